// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// A reading with keys `name`, `joint`, `posture_deg` and, of a half turn, `posture_end_deg`.
struct PostureReading {
  DocumentView reading;
  std::string value;  ///< "352.968 mm"
};

/// Each reading as the arm stands: half turns at both ends with the distance between, others as the
/// posture that they start from.
[[nodiscard]] Figures posture_figures(const ArmModel& arm,
                                      const std::vector<PostureReading>& readings,
                                      const Language& say);

}  // namespace armcal
