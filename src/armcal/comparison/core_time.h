// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal {

/// Seconds that the calling thread has computed. Unlike the clock on the wall it does not count
/// what other threads and programs do meanwhile.
[[nodiscard]] double core_seconds();

}  // namespace armcal
