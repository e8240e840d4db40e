// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace armcal {

/// What a test says of an arm. `undecided`: the test's own uncertainty reaches across the limit.
enum class Verdict { not_judged, pass, undecided, fail };

/// The name as written in JSON.
[[nodiscard]] std::string_view to_string(Verdict verdict);

/// The verdict on everything together: fail before undecided before pass before not_judged.
[[nodiscard]] Verdict worst(std::span<const Verdict> verdicts);

}  // namespace armcal
