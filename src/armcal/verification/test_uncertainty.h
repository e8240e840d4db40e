// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/verification/decision_rule.h"

namespace armcal {

enum class UncertaintySource { certificate, form, temperature, expansion, repeatability };
[[nodiscard]] std::string_view to_string(UncertaintySource source);

/// One line of a budget (GUM 4.3, 5.1.3).
struct UncertaintyContribution {
  std::string name;
  UncertaintySource source = UncertaintySource::certificate;
  double u = 0.0;  ///< standard uncertainty of the input, in `unit`
  std::string unit = "mm";
  double sensitivity = 1.0;  ///< mm of the test value per unit of the input
  double degrees_of_freedom = std::numeric_limits<double>::infinity();

  [[nodiscard]] double u_mm() const;  ///< |sensitivity| u
};

/// Uncertainty of a test value: what the artefact and its surroundings, not the arm, put into it.
struct TestUncertainty {
  std::vector<UncertaintyContribution> contributions;

  /// GUM eq. (10), inputs uncorrelated. theory/verification.md eq. (15)
  [[nodiscard]] double combined_mm() const;
  /// Welch and Satterthwaite, GUM eq. (G.2b); infinite where nothing is of finite freedom.
  /// theory/verification.md eq. (16)
  [[nodiscard]] double effective_degrees_of_freedom() const;
  /// With a fixed coverage factor. @throws std::invalid_argument unless it is finite and positive
  [[nodiscard]] ExpandedUncertainty with_factor(double coverage_factor) const;
  /// With Student's factor for a level of confidence, at the effective degrees of freedom as they
  /// are (GUM G.4.1; not cut to an integer). @throws std::invalid_argument unless in (0, 1)
  [[nodiscard]] ExpandedUncertainty at_level(double level) const;
};

/// A calibrated sphere or length, as its certificate states it, at 20 degC.
struct ArtefactCertificate {
  double value_mm = 0.0;           ///< diameter or length
  double U_mm = 0.0;               ///< expanded uncertainty of the value
  double coverage_factor = 2.0;    ///< of U_mm
  double form_mm = 0.0;            ///< form error of the sphere (or of the faces); 0: not stated
  double expansion_per_k = 0.0;    ///< coefficient of thermal expansion
  double u_expansion_per_k = 0.0;  ///< standard uncertainty of it
};

/// Temperature of the artefact during the test. What the temperature does to the arm is the arm's
/// own error and belongs to no budget.
struct TestEnvironment {
  double temperature_c = 20.0;
  double u_temperature_k = 0.0;
};

/// The calibrated length or diameter as it is at the temperature of the test: L (1 + a (T - 20)).
/// Errors are stated against this. theory/verification.md eq. (17)
[[nodiscard]] double value_at_temperature_mm(const ArtefactCertificate& artefact,
                                             const TestEnvironment& environment);

/// Mean of repeated test values: their scatter as a contribution of n - 1 degrees of freedom, s
/// over the root of n (GUM 4.2.3). Not part of the budgets below: scatter of the arm is what the
/// tests judge. Add it where the test value is a mean. @throws std::invalid_argument for less than
/// 2
[[nodiscard]] UncertaintyContribution repeatability_of_mean(std::span<const double> values_mm);

// Budgets of the test values. Certificate, temperature and expansion follow GUM 5.1; how the form
// of the sphere enters is our reading: no public description says it, and each function tells.
// Contributions of nothing are left out.
// @throws std::invalid_argument for a certificate that is not positive, and for uncertainties, form
// or coverage factor that are negative or not finite

/// Of a length error: certificate, L a u_T, L |T - 20| u_a.
[[nodiscard]] TestUncertainty length_error_uncertainty(const ArtefactCertificate& length,
                                                       const TestEnvironment& environment);

/// Of a diameter: as of a length, and the form F as a radius anywhere within +-F/2 (rectangular).
[[nodiscard]] TestUncertainty probing_size_uncertainty(const ArtefactCertificate& sphere,
                                                       const TestEnvironment& environment);

/// Of a form error: half the form of the sphere. Diameter and temperature do not enter.
[[nodiscard]] TestUncertainty probing_form_uncertainty(const ArtefactCertificate& sphere);

/// Of the distance of fitted centres: half the form of the sphere, which moves a centre that is
/// fitted to few points. Diameter and temperature do not enter, for radii are free.
[[nodiscard]] TestUncertainty location_uncertainty(const ArtefactCertificate& sphere);

}  // namespace armcal
