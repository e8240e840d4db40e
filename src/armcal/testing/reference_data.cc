// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/reference_data.h"

#include <cstdlib>

namespace armcal::testing {

std::filesystem::path reference_data() {
  const char* from_environment = std::getenv("ARMCAL_REFERENCE_DATA");
  return from_environment != nullptr ? from_environment : ARMCAL_REFERENCE_DATA_DEFAULT;
}

std::filesystem::path repository() { return ARMCAL_SOURCE_DIR; }

}  // namespace armcal::testing
