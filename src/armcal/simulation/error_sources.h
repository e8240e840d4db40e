// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/simulation/errors/encoder_noise.h"
#include "armcal/simulation/errors/geometry.h"

namespace armcal {

/// Everything that makes an arm differ from its drawing. All off by default.
struct ErrorSources {
  GeometryErrors geometry;
  EncoderNoise encoder_noise;
};

}  // namespace armcal
