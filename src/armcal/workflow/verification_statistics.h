// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/io/verification_file.h"
#include "armcal/report/verification_result.h"
#include "armcal/verification/b89_4_22/single_point_articulation.h"
#include "armcal/verification/test_result.h"
#include "armcal/workflow/verification_groups.h"

namespace armcal {

/// One test of a file with everything that it is judged by.
struct PreparedTest {
  const StatedTest& stated;
  const StatedArtefact* artefact;  ///< null in a seat
  TestEnvironment environment;
  std::optional<double> reach_mm;
};

/// What the rooms of the standards find in readings of this test: size and form for probing, two
/// statistics for every seat of single-point articulation, and so on. Readings that cannot be made
/// into what the test is asked about are errors.
/// @param first_axis_mm  origin of the arm's first joint in the frame of the tips
[[nodiscard]] std::vector<TestResult> statistics_of(const PreparedTest& test,
                                                    const RowsWithTips& tips,
                                                    const Eigen::Vector3d& first_axis_mm,
                                                    Diagnostics& diagnostics);

/// The budgets of one of these statistics, counted from 0: one for each calibrated length where
/// lengths are errors one by one, else one.
///
/// Of single-point articulation, half range and the standard deviation of diameters nothing
/// certified is part: only what the test states of its own repeatability. Of 2 RMS: twice the
/// uncertainty of the most uncertain length, for errors that share an error d change it by at most
/// 2 d.
[[nodiscard]] std::vector<TestBudget> budgets_of(const PreparedTest& test, std::size_t statistic);

/// The uncertainty that `judge` wants for each part of a result, or one for all.
[[nodiscard]] std::vector<ExpandedUncertainty> uncertainties_of(
    const std::vector<TestBudget>& budgets, const PreparedTest& test, const TestResult& result,
    double coverage_factor);

/// The limit of one of these statistics; nothing where the file states none.
[[nodiscard]] std::optional<MaximumPermissibleError> limit_of(const StatedTest& test,
                                                              std::size_t statistic);

}  // namespace armcal
