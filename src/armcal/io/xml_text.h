// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace armcal {

/// Text as it stands in XML and SVG, between tags or in a quoted attribute. Control characters,
/// which XML does not have, become blanks.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace armcal
