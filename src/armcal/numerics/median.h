// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace armcal {

/// The middle value, or the mean of the two middle ones. @param values  at least one
[[nodiscard]] double median(std::vector<double> values);

}  // namespace armcal
