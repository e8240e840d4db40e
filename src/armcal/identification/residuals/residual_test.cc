// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/residual.h"

#include <gtest/gtest.h>

#include <numeric>

#include "armcal/identification/estimation_problem.h"
#include "armcal/identification/residuals/measured_point.h"
#include "armcal/numerics/derivative_check.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/synthetic_readings.h"

// Laws that every kind of reference keeps: its readings of a true arm leave no residual at the
// truth, and its analytic derivatives by the arm, frames, points and targets are those of its
// residuals.
namespace armcal {
namespace {

using testing::SyntheticReadings;

struct KindCase {
  const char* name;
  std::vector<ObservationGroup> (*make)(SyntheticReadings&);
};

std::vector<ObservationGroup> with(ObservationGroup group, const std::string& target,
                                   const Eigen::Vector3d& offset) {
  group.target = target;
  group.offset_mm = offset;
  return {std::move(group)};
}

const KindCase kKinds[] = {
    {"reference_points",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reference_points(19, "A")};
     }},
    {"reference_points_of_two_setups",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reference_points(9, "A"), s.reference_points(11, "B")};
     }},
    {"reference_points_of_a_target",
     [](SyntheticReadings& s) {
       return with(s.reference_points(19, "A"), "ball", Eigen::Vector3d::Zero());
     }},
    {"reference_points_at_an_offset",
     [](SyntheticReadings& s) {
       return with(s.reference_points(19, "A"), "", {3, -5, 7});
     }},
    {"reference_poses",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reference_poses(17, "A")};
     }},
    {"reference_poses_of_a_target",
     [](SyntheticReadings& s) {
       return with(s.reference_poses(17, "A"), "mac", Eigen::Vector3d::Zero());
     }},
    {"fixed_point",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.fixed_points({"P", "Q"}, 9)};
     }},
    {"length",
     [](SyntheticReadings& s) {
       std::vector<ObservationGroup> groups = {s.fixed_points({"P", "Q"}, 9)};
       groups.push_back(s.length("P", "Q"));
       return groups;
     }},
    {"artefact",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.artefact(5, 3, "flat")};
     }},
    {"artefact_bar",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.artefact(2, 6, "bar")};
     }},
    {"reversal",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> { return {s.reversals(21)}; }},
    {"reversal_read_at_both_ends",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       ObservationGroup group = s.reversals(21);
       for (double& angle : group.encoder_end_rad.reshaped()) angle += 1e-3 * s.random().normal();
       const Eigen::Matrix3Xd before = moving_tips(s.truth(), group.encoder_rad).at_mm;
       const Eigen::Matrix3Xd after = moving_tips(s.truth(), group.encoder_end_rad).at_mm;
       group.value_mm = (before - after).colwise().norm();
       return {group};
     }},
    {"circle_radius",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> { return {s.circle_radii(21)}; }},
    {"sphere_known",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.sphere(21, 40.0, true)};
     }},
    {"sphere_unknown",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.sphere(21, 40.0, false)};
     }},
    {"plane", [](SyntheticReadings& s) -> std::vector<ObservationGroup> { return {s.plane(21)}; }},
};

class EveryKind : public ::testing::TestWithParam<KindCase> {
 protected:
  // The groups as a problem in all parameters of an arm and all that they bring along.
  void build(const ArmModel& arm, const std::vector<ObservationGroup>& groups) {
    std::vector<int> all(static_cast<std::size_t>(ParameterTable(arm).size()));
    std::iota(all.begin(), all.end(), 0);
    unknowns_.emplace(arm, all);
    for (const ObservationGroup& group : groups) {
      for (auto& residual : residuals_of(group, false, *unknowns_))
        residuals_.push_back(std::move(residual));
    }
    for (const auto& residual : residuals_) pointers_.push_back(residual.get());
    x_ = unknowns_->start();
    const ArmAt at{arm, TipRows(arm, unknowns_->columns())};
    for (const auto& residual : residuals_)
      ASSERT_EQ(residual->start(at, *unknowns_, x_), std::nullopt);
  }

  // Residuals against a reference machine are turned back into the base frame by the set-up as it
  // is; their derivatives are those of the residual in the reference frame, turned alike. So the
  // turn is undone and redone with the set-up at x_.
  Eigen::VectorXd seen_from_the_reference(const EstimationProblem& problem,
                                          const Eigen::VectorXd& x) const {
    Eigen::VectorXd residuals = residuals_at(problem, x);
    Eigen::Index row = 0;
    for (const EstimationProblem::Block& block : problem.blocks()) {
      const Eigen::Index rows =
          problem.shape(static_cast<int>(&block - problem.blocks().data())).rows;
      for (const int id :
           block.residual == nullptr ? std::vector<int>{} : block.residual->nuisances()) {
        if ((*unknowns_)[id].name.rfind("setup.", 0) != 0) continue;
        const Eigen::Matrix3d turn =
            unknowns_->frame(x_, id).rotation.transpose() * unknowns_->frame(x, id).rotation;
        for (Eigen::Index k = 0; k < rows; k += 3) {
          residuals.segment<3>(row + k) = (turn * residuals.segment<3>(row + k)).eval();
        }
      }
      row += rows;
    }
    return residuals;
  }

  std::optional<Unknowns> unknowns_;
  std::vector<std::unique_ptr<Residual>> residuals_;
  std::vector<const Residual*> pointers_;
  Eigen::VectorXd x_;
};

Eigen::MatrixXd jacobian_of(const EstimationProblem& problem, const Eigen::VectorXd& x) {
  Eigen::MatrixXd whole =
      Eigen::MatrixXd::Zero(residuals_at(problem, x).size(), problem.unknown_count());
  const auto at = problem.at(x);
  Eigen::Index first = 0;
  for (int b = 0; b < problem.block_count(); ++b) {
    const auto shape = problem.shape(b);
    const auto columns = static_cast<Eigen::Index>(shape.columns.size());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows =
        Eigen::MatrixXd::Zero(shape.rows, columns + 1);
    at->fill(b, {shape.rows, columns, columns + 1, rows.data()});
    for (Eigen::Index c = 0; c < columns; ++c) {
      whole.block(first, shape.columns[static_cast<std::size_t>(c)], shape.rows, 1) = rows.col(c);
    }
    first += shape.rows;
  }
  return whole;
}

TEST_P(EveryKind, HasTheDerivativesOfItsResiduals) {
  RandomStream random(11, 0);
  const ArmModel truth = testing::random_arm(6, random);
  SyntheticReadings readings(truth, 12, 0.5);
  const auto groups = GetParam().make(readings);
  build(testing::perturbed(truth, random, 1.0, 0.003), groups);
  const EstimationProblem problem(pointers_, *unknowns_, {{0, 0.1, 0.02}, {7, 1.0, 3.0}});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(problem.unknown_count());
  Eigen::VectorXd steps(problem.unknown_count());
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    const std::string name = unknowns_->names()[static_cast<std::size_t>(i)];
    const bool is_angle = name.find(".r") != name.npos || name.find("tilt") != name.npos ||
                          name.rfind("zero", 0) == 0 || name.rfind("alpha", 0) == 0 ||
                          name.rfind("beta", 0) == 0 || name.rfind("cos", 0) == 0 ||
                          name.rfind("sin", 0) == 0;
    steps(i) = is_angle && name.find("radius") == name.npos ? 0.02 : 10.0;
  }
  const auto moved = [&](const Eigen::VectorXd& step) {
    const Eigen::VectorXd x = problem.moved(x_, step);
    return seen_from_the_reference(problem, x);
  };
  // In units of a step of each unknown: what no reading depends on is rounding there, not a
  // derivative.
  const Eigen::MatrixXd reference =
      jacobian_by_differences(moved, zero, steps) * steps.asDiagonal();
  const Eigen::MatrixXd analytic = jacobian_of(problem, x_) * steps.asDiagonal();
  const double floor = 1e-3 * reference.cwiseAbs().maxCoeff();
  for (Eigen::Index c = 0; c < reference.cols(); ++c) {
    const double size = std::max(floor, reference.col(c).cwiseAbs().maxCoeff());
    EXPECT_LT((analytic - reference).col(c).cwiseAbs().maxCoeff(), 2e-9 * size)
        << unknowns_->names()[static_cast<std::size_t>(c)];
  }
}

// All rows of all groups, one residual below the other, in mm.
Eigen::VectorXd residuals_mm(const std::vector<ObservationGroup>& groups, Unknowns unknowns,
                             const Eigen::VectorXd& x) {
  std::vector<std::unique_ptr<Residual>> residuals;
  for (const ObservationGroup& group : groups) {
    for (auto& residual : residuals_of(group, false, unknowns))
      residuals.push_back(std::move(residual));
  }
  std::vector<const Residual*> pointers;
  for (const auto& residual : residuals) pointers.push_back(residual.get());
  return residuals_at(EstimationProblem(pointers, unknowns, {}), x);
}

// The encoders of all rows off by the same: joints, then joints after a turn. A locked joint that
// shows the same at both ends was read once.
std::vector<ObservationGroup> with_encoders_off(std::vector<ObservationGroup> groups,
                                                const Eigen::VectorXd& off_rad) {
  for (ObservationGroup& group : groups) {
    for (Eigen::Index i = 0; i < group.encoder_rad.cols(); ++i) {
      for (Eigen::Index joint = 0; joint < group.encoder_rad.rows(); ++joint) {
        if (group.kind == ReferenceKind::reversal) {
          const bool once = group.encoder_end_rad(joint, i) == group.encoder_rad(joint, i);
          const Eigen::Index after = once ? joint : group.encoder_rad.rows() + joint;
          group.encoder_end_rad(joint, i) += off_rad(after);
        }
        group.encoder_rad(joint, i) += off_rad(joint);
      }
    }
  }
  return groups;
}

TEST_P(EveryKind, KnowsHowItsResidualsMoveWithTheEncoders) {
  RandomStream random(13, 0);
  ArmModel truth = testing::random_arm(6, random);
  truth.joints[2].harmonics = {{0.01, -0.02}};
  truth.joints[3].direction = -1;
  SyntheticReadings readings(truth, 14, 0.5);
  auto groups = GetParam().make(readings);
  for (ObservationGroup& group : groups) group.u_mm.setConstant(1.0);
  build(testing::perturbed(truth, random, 1.0, 0.003), groups);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(12);
  const Eigen::MatrixXd reference = jacobian_by_differences(
      [&](const Eigen::VectorXd& off_rad) {
        return residuals_mm(with_encoders_off(groups, off_rad), *unknowns_, x_);
      },
      zero, Eigen::VectorXd::Constant(12, 0.02));
  Eigen::Index row = 0;
  for (const auto& residual : residuals_) {
    const Eigen::MatrixXd J = residual->J_residual_encoders(unknowns_->arm_at(x_), *unknowns_, x_);
    ASSERT_EQ(J.rows(), residual->count() * residual->rows_per_observation());
    const Eigen::MatrixXd own = reference.middleRows(row, J.rows());
    const double size = std::max(1.0, own.cwiseAbs().maxCoeff());
    EXPECT_LT((own.leftCols(J.cols()) - J).cwiseAbs().sum(), 1e-7 * size);
    // What it does not tell of does not move it.
    EXPECT_EQ(own.rightCols(12 - J.cols()).cwiseAbs().sum(), 0.0);
    row += J.rows();
  }
  EXPECT_EQ(row, reference.rows());
}

// The law of eq. (18): whitened derivatives by the encoders, in units of their uncertainty, and the
// whitened scatter of the reference together are the unit matrix.
TEST_P(EveryKind, WhitensItsRowsByTheirWholeCovariance) {
  RandomStream random(15, 0);
  const ArmModel truth = testing::random_arm(6, random);
  SyntheticReadings readings(truth, 16, 0.5);
  auto groups = GetParam().make(readings);
  constexpr double kEncoder_rad = 5e-4;
  for (ObservationGroup& group : groups) group.u_encoder_rad = kEncoder_rad;
  build(truth, groups);
  weigh_all(residuals_, *unknowns_, x_);
  for (const auto& residual : residuals_) {
    const Eigen::Index size = residual->rows_per_observation();
    const Eigen::MatrixXd J =
        kEncoder_rad * residual->J_residual_encoders(unknowns_->arm_at(x_), *unknowns_, x_);
    for (Eigen::Index i = 0; i < residual->count(); ++i) {
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(
          size, J.cols() + size + 1);
      rows << J.middleRows(i * size, size),
          residual->group().u_mm(residual->row(i)) * Eigen::MatrixXd::Identity(size, size),
          Eigen::VectorXd::Zero(size);
      residual->whiten(i, 1, {size, rows.cols() - 1, rows.cols(), rows.data()});
      EXPECT_LT((rows * rows.transpose() - Eigen::MatrixXd::Identity(size, size)).norm(), 1e-10);
      const double largest = rows.middleCols(J.cols(), size).rowwise().norm().maxCoeff();
      EXPECT_NEAR(residual->largest_weight(i) * residual->group().u_mm(residual->row(i)), largest,
                  1e-12 * largest);
    }
  }
}

TEST_P(EveryKind, LeavesNoResidualAtTheTruth) {
  RandomStream random(21, 0);
  const ArmModel truth = testing::random_arm(6, random);
  SyntheticReadings readings(truth, 22, 0.0);
  auto groups = GetParam().make(readings);
  for (ObservationGroup& group : groups) {
    group.offset_mm.setZero();
    group.u_mm.setConstant(1.0);
  }
  build(truth, groups);
  const EstimationProblem problem(pointers_, *unknowns_, {});
  // What the start values do not give exactly the readings do, the arm staying as it is.
  std::vector<int> arm(static_cast<std::size_t>(unknowns_->arm_size()));
  std::iota(arm.begin(), arm.end(), 0);
  const EstimationProblem places(pointers_, *unknowns_, {}, arm);
  Eigen::VectorXd x = x_;
  if (places.unknown_count() > 0) {
    for (int i = 0; i < 3; ++i) x = solve_least_squares(places, x).x;
  }
  EXPECT_LT(residuals_at(problem, x).lpNorm<Eigen::Infinity>(), 2e-8);
}

TEST_P(EveryKind, CanHoldAnyOfItsUnknowns) {
  RandomStream random(31, 0);
  SyntheticReadings readings(testing::random_arm(6, random), 32, 0.5);
  const auto groups = GetParam().make(readings);
  build(readings.truth(), groups);
  const EstimationProblem whole(pointers_, *unknowns_, {});
  const Eigen::MatrixXd all = jacobian_of(whole, x_);
  std::vector<int> held;
  for (int i = 0; i < unknowns_->step_size(); i += 3) held.push_back(i);
  const EstimationProblem part(pointers_, *unknowns_, {}, held);
  const Eigen::MatrixXd some = jacobian_of(part, x_);
  ASSERT_EQ(some.cols(), static_cast<Eigen::Index>(part.active().size()));
  for (Eigen::Index c = 0; c < some.cols(); ++c) {
    EXPECT_EQ(some.col(c), all.col(part.active()[static_cast<std::size_t>(c)]));
  }
}

INSTANTIATE_TEST_SUITE_P(OfReference, EveryKind, ::testing::ValuesIn(kKinds),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace armcal
