// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/arm_of.h"

#include "armcal/io/arm_file.h"

namespace armcal {

ArmModel arm_of(const DocumentView& document, std::string_view key) {
  Diagnostics diagnostics;
  const TextFile file{std::string(key), document.text(key), "UTF-8", ""};
  const auto arm = read_arm(file, diagnostics);
  if (!arm) document[key].complain("is no arm: " + diagnostics.entries().front().message);
  return *arm;
}

}  // namespace armcal
