// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"
#include "armcal/report/pages/residual_rows.h"

namespace armcal {

/// The calibrated arm in its measured postures with enlarged residuals: drawn, and to turn in
/// space.
[[nodiscard]] Section arm_section(const DocumentView& document,
                                  const std::vector<ResidualRow>& rows, const Language& say);

/// Residuals against each joint angle, reach, order or time, as histogram and normal quantiles.
[[nodiscard]] Figures residual_figures(const std::vector<ResidualRow>& rows, const Language& say);

/// Which part of joint space and of the volume the readings cover.
[[nodiscard]] Section coverage_section(const DocumentView& document,
                                       const std::vector<ResidualRow>& rows, const Language& say);

/// Change of each parameter in its unit, with U = 2 u.
[[nodiscard]] Figures parameter_changes(const DocumentView& document, const Language& say);

/// Correlations of the parameters, and how the iteration went.
[[nodiscard]] Section numerics_section(const DocumentView& document, const Language& say);

}  // namespace armcal
