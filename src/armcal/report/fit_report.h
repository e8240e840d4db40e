// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/geometry/circle.h"
#include "armcal/geometry/line.h"
#include "armcal/geometry/plane.h"
#include "armcal/geometry/registration.h"
#include "armcal/geometry/sphere.h"
#include "armcal/report/document.h"

namespace armcal {

// Best-fit elements and registrations as JSON and as text for a terminal. Only for fits that
// converged.
[[nodiscard]] Json json_result(const CircleFit& fit);
[[nodiscard]] Json json_result(const SphereFit& fit);
[[nodiscard]] Json json_result(const PlaneFit& fit);
[[nodiscard]] Json json_result(const LineFit& fit);
[[nodiscard]] Json json_result(const Registration& fit);

[[nodiscard]] std::string text_result(const CircleFit& fit);
[[nodiscard]] std::string text_result(const SphereFit& fit);
[[nodiscard]] std::string text_result(const PlaneFit& fit);
[[nodiscard]] std::string text_result(const LineFit& fit);
[[nodiscard]] std::string text_result(const Registration& fit);

}  // namespace armcal
