// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace armcal {

/// JSON as it may stand inside a script element of HTML: nothing in it ends the element or starts a
/// comment. It stays the same JSON.
[[nodiscard]] std::string script_safe(std::string_view json);

/// What script_safe() was given, byte for byte, provided that held no `<`, `>` or `&` written as
/// `\u003c`, `\u003e`, `\u0026` already; nlohmann::json writes them as they are.
[[nodiscard]] std::string from_script(std::string_view safe);

}  // namespace armcal
