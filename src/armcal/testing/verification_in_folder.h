// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/verification_readings.h"
#include "armcal/workflow/verification_job.h"

namespace armcal::testing {

/// A ball of 25 mm and a bar of five lengths; tests are added to it.
inline constexpr const char* kVerificationHead = R"(schema = "armcal.verification/1"
reach_mm = 1000
[[artefact]]
name = "ball"
kind = "sphere"
diameter_mm = 25
U_um = 1.0
[[artefact]]
name = "bar"
kind = "lengths"
lengths = [[200, 1], [400, 1], [600, 1], [800, 1], [1000, 1]]
)";

inline constexpr const char* kLengthTest = R"([[test]]
kind = "length_uni"
artefact = "bar"
file = "lengths.csv"
mpe_um = "20 + L/50"
)";

inline constexpr double kExact_mm = 1e-9;  ///< what files and fits of exact points lose

inline std::string point_row(const std::string& fields, const Eigen::Vector3d& p) {
  return fmt::format("{},{},{},{}\n", fields, p.x(), p.y(), p.z());
}

/// Points at a distance from a centre.
inline std::string sphere_rows(const std::string& fields, const Eigen::Vector3d& center,
                               double radius_mm, int count) {
  std::string rows;
  for (const Eigen::Vector3d& direction : probing_directions(count)) {
    rows += point_row(fields, center + radius_mm * direction);
  }
  return rows;
}

/// Writes verification files and tables, and judges by them.
class VerificationInFolder : public ::testing::Test {
 protected:
  Verification run(const std::string& tests, VerificationStandard standard,
                   bool incomplete = false) {
    const std::string path = folder_.write("arm.verification.toml", kVerificationHead + tests);
    InputFiles files;
    VerificationWishes wishes;
    wishes.standard = standard;
    wishes.incomplete = incomplete;
    return run_verification(files, path, wishes);
  }
  Verification iso(const std::string& tests, bool incomplete = false) {
    return run(tests, VerificationStandard::iso10360_12, incomplete);
  }
  Verification asme(const std::string& tests, bool incomplete = false) {
    return run(tests, VerificationStandard::b89_4_22, incomplete);
  }
  std::string complaint(const std::string& tests, VerificationStandard standard,
                        bool incomplete = false) {
    try {
      static_cast<void>(run(tests, standard, incomplete));
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "was accepted:\n" << tests;
    return {};
  }
  std::string iso_complaint(const std::string& tests, bool incomplete = false) {
    return complaint(tests, VerificationStandard::iso10360_12, incomplete);
  }

  TemporaryFolder folder_;
};

}  // namespace armcal::testing
