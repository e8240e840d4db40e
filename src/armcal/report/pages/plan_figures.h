// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// A point of a document: three numbers under a key.
[[nodiscard]] Eigen::Vector3d point_under(const DocumentView& view, std::string_view key);

/// The tests of one standard from above and from the side. Nothing for plans that were saved before
/// they knew what stands around the arm.
/// @param id  of the figures: with -top and -side behind it
[[nodiscard]] Figures plan_figures(const DocumentView& document,
                                   const std::vector<DocumentView>& tests, const std::string& id,
                                   const Language& say);

/// "near", "along x": a position that armcal names, in the language of the reader.
[[nodiscard]] std::string plan_position(const std::string& name, const Language& say);

}  // namespace armcal
