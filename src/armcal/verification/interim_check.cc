// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/interim_check.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "armcal/core/diagnostics.h"
#include "armcal/geometry/sphere.h"
#include "armcal/verification/b89_4_22/single_point_articulation.h"
#include "armcal/verification/half_range.h"

namespace armcal {
namespace {

// The one list of what a check may find.
struct Kind {
  std::string_view name;
  const char* title;
  const char* definition;
  std::optional<double> CheckLimits::*limit;
  bool is_signed;
  bool is_watched;
};
constexpr const char* kHalfRange = "(largest - smallest) / 2 of this coordinate";
constexpr std::array<Kind, 9> kKinds = {{
    {"max_deviation", "largest deviation",
     "largest distance in space of a point from the mean of its seat", &CheckLimits::deviation_mm,
     false, true},
    {"two_s", "2 s", "twice s, the root of the sum of the squares of those distances over (n - 1)",
     &CheckLimits::twice_s_mm, false, false},
    {"half_range_x", "half range of x", kHalfRange, &CheckLimits::half_range_mm, false, false},
    {"half_range_y", "half range of y", kHalfRange, &CheckLimits::half_range_mm, false, false},
    {"half_range_z", "half range of z", kHalfRange, &CheckLimits::half_range_mm, false, false},
    {"diameter_error", "diameter error",
     "diameter of the least-squares sphere, less that of the probe, less the certified one",
     &CheckLimits::diameter_mm, true, true},
    {"form_error", "form error",
     "largest less smallest distance of the points from the centre of that sphere",
     &CheckLimits::form_mm, false, true},
    {"length", "length", "distance of the two mean points or centres", nullptr, false, false},
    {"length_error", "length error", "that distance less the certified length",
     &CheckLimits::length_mm, true, true},
}};

const Kind* find(std::string_view name) {
  for (const Kind& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

void add(InterimCheck& check, std::string_view name, double value_mm, const CheckLimits& limits) {
  const Kind& kind = *find(name);
  CheckValue value{std::string(name),
                   kind.title,
                   kind.definition,
                   value_mm,
                   kind.limit != nullptr ? limits.*kind.limit : std::nullopt,
                   Verdict::not_judged};
  if (value.limit_mm) {
    value.verdict = std::abs(value_mm) <= *value.limit_mm ? Verdict::pass : Verdict::fail;
  }
  check.values.push_back(std::move(value));
}

void check_seats(std::span<const TouchedPlace> places, const CheckLimits& limits,
                 InterimCheck& check) {
  double deviation = 0.0;
  double twice_s = 0.0;
  std::array<double, 3> half_ranges{};
  for (const TouchedPlace& place : places) {
    const b89_4_22::SeatScatter scatter = b89_4_22::scatter_in_seat(place.points_mm);
    check.places.push_back({place.name, place.points_mm.size(), scatter.mean_mm});
    deviation = std::max(deviation, scatter.largest_mm);
    twice_s = std::max(twice_s, scatter.twice_s_mm);
    const TestResult range = half_range(place.points_mm, place.name);
    for (std::size_t axis = 0; axis < half_ranges.size(); ++axis) {
      half_ranges[axis] = std::max(half_ranges[axis], range.parts.at(axis).value_mm);
    }
  }
  add(check, "max_deviation", deviation, limits);
  add(check, "two_s", twice_s, limits);
  add(check, "half_range_x", half_ranges[0], limits);
  add(check, "half_range_y", half_ranges[1], limits);
  add(check, "half_range_z", half_ranges[2], limits);
}

void check_spheres(std::span<const TouchedPlace> places, const InterimCheckOptions& options,
                   InterimCheck& check) {
  double diameter_error = 0.0;
  double form_error = 0.0;
  for (const TouchedPlace& place : places) {
    const SphereFit fit = fit_sphere(place.points_mm);
    if (!fit.ok()) {
      throw NumericalError(fmt::format("sphere {}: {}", place.name, explain(fit.status)));
    }
    const double error = 2.0 * fit.radius_mm - options.tip_diameter_mm - *options.diameter_mm;
    if (std::abs(error) > std::abs(diameter_error)) diameter_error = error;
    form_error = std::max(form_error, fit.form_mm);
    check.places.push_back({place.name, place.points_mm.size(), fit.center_mm});
  }
  add(check, "diameter_error", diameter_error, options.limits);
  add(check, "form_error", form_error, options.limits);
}

void check_positive(const std::optional<double>& value, const char* what,
                    std::vector<std::string>& problems) {
  if (value && !(std::isfinite(*value) && *value > 0.0)) {
    problems.push_back(fmt::format("{} {} mm: must be larger than 0", what, *value));
  }
}

// A limit of something that is not measured would seem to be kept.
void check_limits(const InterimCheckOptions& options, std::vector<std::string>& problems) {
  const CheckLimits& limits = options.limits;
  const bool of_seats = limits.deviation_mm || limits.twice_s_mm || limits.half_range_mm;
  const bool of_spheres = limits.diameter_mm || limits.form_mm || options.tip_diameter_mm > 0.0;
  if (options.diameter_mm && of_seats)
    problems.emplace_back("a limit of deviation, 2 s or half range is for seats, not for spheres");
  if (!options.diameter_mm && of_spheres) {
    problems.emplace_back(
        "a tip diameter, and a limit of form error, are for spheres, whose certified diameter is "
        "missing");
  }
  if (limits.length_mm && !options.length_mm)
    problems.emplace_back("a limit of the length error needs the certified length");
  for (const auto limit :
       {&CheckLimits::deviation_mm, &CheckLimits::twice_s_mm, &CheckLimits::half_range_mm,
        &CheckLimits::diameter_mm, &CheckLimits::form_mm, &CheckLimits::length_mm}) {
    check_positive(limits.*limit, "limit", problems);
  }
}

}  // namespace

std::string_view to_string(CheckKind kind) { return kind == CheckKind::seat ? "seat" : "sphere"; }

Verdict InterimCheck::verdict() const {
  std::vector<Verdict> verdicts;
  for (const CheckValue& value : values) verdicts.push_back(value.verdict);
  return worst(verdicts);
}

std::size_t least_points(CheckKind kind) { return kind == CheckKind::seat ? 3 : 5; }
std::size_t advised_points(CheckKind kind) { return kind == CheckKind::seat ? 10 : 9; }

std::vector<std::string> problems_of(std::span<const TouchedPlace> places,
                                     const InterimCheckOptions& options) {
  std::vector<std::string> problems;
  check_positive(options.diameter_mm, "certified diameter", problems);
  check_positive(options.length_mm, "certified length", problems);
  if (!std::isfinite(options.tip_diameter_mm) || options.tip_diameter_mm < 0.0) {
    problems.push_back(
        fmt::format("tip diameter {} mm: must not be negative", options.tip_diameter_mm));
  }
  check_limits(options, problems);
  const CheckKind kind = options.diameter_mm ? CheckKind::sphere : CheckKind::seat;
  if (places.empty()) problems.emplace_back("no points");
  for (const TouchedPlace& place : places) {
    if (place.points_mm.size() >= least_points(kind)) continue;
    problems.push_back(fmt::format(
        "{} points {}{}{}, at least {} are needed, better {}", place.points_mm.size(),
        kind == CheckKind::seat ? "in the seat" : "on the sphere", place.name.empty() ? "" : " ",
        place.name, least_points(kind), advised_points(kind)));
  }
  if (options.length_mm && places.size() != 2) {
    problems.push_back(fmt::format("a length lies between 2 {}s, the readings are of {}",
                                   to_string(kind), places.size()));
  }
  return problems;
}

InterimCheck check_arm(std::span<const TouchedPlace> places, const InterimCheckOptions& options) {
  const std::vector<std::string> problems = problems_of(places, options);
  if (!problems.empty()) {
    throw std::invalid_argument(fmt::format("interim check: {}", fmt::join(problems, "; ")));
  }
  InterimCheck check;
  if (options.diameter_mm) {
    check.kind = CheckKind::sphere;
    check_spheres(places, options, check);
  } else {
    check_seats(places, options.limits, check);
  }
  if (places.size() == 2) {
    const double length_mm = (check.places[1].center_mm - check.places[0].center_mm).norm();
    add(check, "length", length_mm, options.limits);
    if (options.length_mm)
      add(check, "length_error", length_mm - *options.length_mm, options.limits);
  }
  return check;
}

bool is_watched(std::string_view name) {
  const Kind* kind = find(name);
  return kind != nullptr && kind->is_watched;
}

bool is_signed(std::string_view name) {
  const Kind* kind = find(name);
  return kind != nullptr && kind->is_signed;
}

std::string title_of(std::string_view name) {
  const Kind* kind = find(name);
  return kind != nullptr ? kind->title : std::string(name);
}

}  // namespace armcal
