// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal::b89_4_22 {

inline constexpr const char* kStandard = "ASME B89.4.22-2004";

}  // namespace armcal::b89_4_22
