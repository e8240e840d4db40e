// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/error_sources.h"

#include <array>
#include <type_traits>

namespace armcal {
namespace {

template <auto kMember>
constexpr ErrorSource source(std::string_view name, std::string_view brief) {
  return {name, brief, [](const ErrorSources& errors) { return (errors.*kMember).is_on(); },
          [](ErrorSources& errors) {
            auto& options = errors.*kMember;
            options = std::remove_reference_t<decltype(options)>::typical();
          }};
}

constexpr std::array kSources = {
    // clang-format off
    source<&ErrorSources::geometry>("geometry", "zeros, twists, offsets and lengths as built"),
    source<&ErrorSources::encoder_noise>("encoder_noise", "noise and steps of the encoders"),
    source<&ErrorSources::scale_eccentricity>("scale_eccentricity", "eccentric and tilted scales"),
    source<&ErrorSources::bearing_run_out>("bearing_run_out", "axes that wander as they turn"),
    source<&ErrorSources::gravity_sag>("gravity_sag", "links and bearings that give way to weight"),
    source<&ErrorSources::thermal_expansion>("thermal_expansion", "links at another temperature"),
    source<&ErrorSources::probing_force>("probing_force", "arm and stylus that give way to the probing force"),
    source<&ErrorSources::base_movement>("base_movement", "a foot that moves and tilts"),
    source<&ErrorSources::warm_up_drift>("warm_up_drift", "zeros and lengths that creep with time"),
    source<&ErrorSources::blunders>("blunders", "readings that are simply wrong")
    // clang-format on
};

}  // namespace

ErrorSources ErrorSources::typical() {
  ErrorSources errors;
  for (const ErrorSource& source : kSources) source.switch_on(errors);
  errors.blunders = {};
  return errors;
}

std::span<const ErrorSource> error_source_list() { return kSources; }

}  // namespace armcal
