// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/joint_chain.h"
#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"

namespace armcal {

/// Is it XML by its name (*.urdf, *.xacro) or its first character?
[[nodiscard]] bool looks_like_urdf(const TextFile& file);

/// Reads the joints of a robot description (URDF, docs/files/urdf.md) from one link to another:
/// revolute and continuous joints with any axis, fixed ones folded in; metres become mm. What is
/// off the chain need only hang together.
/// @param chain  "BASE:TIP", names of links; without it the way from the root to the one leaf
/// All problems go to `diagnostics`, with line and column; with errors nothing is returned.
[[nodiscard]] std::optional<JointChain> read_urdf_chain(const TextFile& file,
                                                        const std::optional<std::string>& chain,
                                                        Diagnostics& diagnostics);

/// The same as an arm: same poses of the tip link to 1e-9 mm, readings = joint values.
[[nodiscard]] std::optional<ArmModel> read_urdf(const TextFile& file,
                                                const std::optional<std::string>& chain,
                                                Diagnostics& diagnostics);

}  // namespace armcal
