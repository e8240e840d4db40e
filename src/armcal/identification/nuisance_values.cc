// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/nuisance_values.h"

namespace armcal {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};
constexpr const char* kTurns[] = {"rx", "ry", "rz"};

class Listing {
 public:
  Listing(std::string name, std::vector<NuisanceValue>& values)
      : name_(std::move(name)), values_(values) {}

  // Three components; rows of `factor` are their derivatives times the factor of the covariance.
  void add(const char* const (&parts)[3], ParameterUnit unit, const Eigen::Vector3d& value,
           const Eigen::MatrixXd& factor, const std::string& prefix = "") {
    for (int k = 0; k < 3; ++k) add(prefix + parts[k], unit, value(k), factor.row(k).norm());
  }
  void add(const std::string& part, ParameterUnit unit, double value, double u) {
    values_.push_back({name_ + "." + part, unit, value, u});
  }

 private:
  std::string name_;
  std::vector<NuisanceValue>& values_;
};

}  // namespace

std::vector<NuisanceValue> nuisance_values(const Unknowns& unknowns, const Eigen::VectorXd& x,
                                           const Eigen::MatrixXd& factor) {
  std::vector<NuisanceValue> values;
  for (int id = 0; id < static_cast<int>(unknowns.nuisances().size()); ++id) {
    const Nuisance& nuisance = unknowns[id];
    Listing listing(nuisance.name, values);
    const auto rows = [&](Eigen::Index first) {
      return factor.middleRows(nuisance.step + first, 3);
    };
    switch (nuisance.kind) {
      case NuisanceKind::frame: {
        const RigidTransform pose = unknowns.frame(x, id);
        const Eigen::MatrixXd of_origin =
            rows(3) - skew(pose.translation_mm - nuisance.pivot_mm) * rows(0);
        listing.add(kAxes, ParameterUnit::mm, pose.translation_mm, of_origin);
        listing.add(kTurns, ParameterUnit::rad, vector_from_rotation(pose.rotation), rows(0));
        break;
      }
      case NuisanceKind::point:
        listing.add(kAxes, ParameterUnit::mm, unknowns.point(x, id), rows(0));
        break;
      case NuisanceKind::radius:
        listing.add("radius", ParameterUnit::mm, unknowns.radius(x, id),
                    factor.row(nuisance.step).norm());
        break;
      case NuisanceKind::plane: {
        const Eigen::Vector4d plane = unknowns.plane(x, id);
        const auto [first, second] = perpendicular_pair(plane.head<3>());
        Eigen::Matrix3d by_tilt = Eigen::Matrix3d::Zero();
        by_tilt.col(0) = first;
        by_tilt.col(1) = second;
        listing.add(kAxes, ParameterUnit::rad, plane.head<3>(), by_tilt * rows(0), "n");
        const Eigen::RowVector3d by_step(first.dot(nuisance.pivot_mm),
                                         second.dot(nuisance.pivot_mm), 1.0);
        listing.add("distance", ParameterUnit::mm, plane(3), (by_step * rows(0)).norm());
        break;
      }
      case NuisanceKind::rotation:
        listing.add(kTurns, ParameterUnit::rad, vector_from_rotation(unknowns.rotation(x, id)),
                    rows(0));
        break;
    }
  }
  return values;
}

}  // namespace armcal
