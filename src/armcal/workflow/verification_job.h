// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/report/verification_result.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

enum class VerificationStandard { iso10360_12, b89_4_22 };

/// What a user says beside the verification file.
struct VerificationWishes {
  VerificationStandard standard = VerificationStandard::iso10360_12;
  std::optional<std::string> arm_file;      ///< instead of the file's
  std::optional<std::string> as_left_file;  ///< instead of the file's
  bool incomplete = false;                  ///< compute what less readings give, without symbols
  bool keep_duplicates = false;
  bool keep_zero_points = false;
};

/// Runs the tests of one standard that a verification file holds, with the half range among those
/// of ASME B89.4.22: readings as angles put through the arm as found and, where there is one, the
/// same angles through the arm as left.
///
/// Of readings that say a length themselves, or coordinates, there is no second opinion: then the
/// arm as left is not judged, with a warning.
/// @throws InputError for what is missing of a test (unless `incomplete`), and for readings that
/// cannot be those of the artefact; NumericalError where nothing could be computed
[[nodiscard]] Verification run_verification(InputFiles& files, const std::string& path,
                                            const VerificationWishes& wishes);

}  // namespace armcal
