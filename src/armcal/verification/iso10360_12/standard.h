// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal::iso10360_12 {

inline constexpr const char* kStandard = "ISO 10360-12:2016";

}  // namespace armcal::iso10360_12
