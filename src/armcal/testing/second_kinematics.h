// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal::testing {

/// The tip of an arm for numbers of any kind, automatic derivatives among them: a second forward
/// kinematics that shares no code with the library's. It carries the point from the tip back to the
/// base, joint by joint, where the library carries axes from the base to the tip.
///
/// Numbers of the arm stand in the order of its parameter table, which is spelled out here once
/// more: zeros; d b a alpha beta of every link; a b d of the tip; cos and sin of every harmonic,
/// joint by joint. Those that are not free keep the value that they have in the arm.
class SecondKinematics {
 public:
  /// @param free  places in that order, ascending
  SecondKinematics(const ArmModel& arm, const std::vector<int>& free) {
    base_ = arm.base_from_first_joint;
    for (const Joint& joint : arm.joints) {
      numbers_.push_back({joint.zero_rad});
      joints_.push_back({joint.direction, joint.harmonics.size()});
    }
    for (const Link& link : arm.links) {
      for (const double value : {link.d_mm, link.b_mm, link.a_mm, link.alpha_rad, link.beta_rad}) {
        numbers_.push_back({value});
      }
    }
    for (const double value : {arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm}) {
      numbers_.push_back({value});
    }
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      joints_[i].first_harmonic = numbers_.size();
      for (const Harmonic& harmonic : arm.joints[i].harmonics) {
        numbers_.push_back({harmonic.cos_rad});
        numbers_.push_back({harmonic.sin_rad});
      }
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
      numbers_[static_cast<std::size_t>(free[i])].place = static_cast<int>(i);
    }
  }

  /// Tip in the base frame, mm. @param free  values of the free numbers
  template <class T>
  [[nodiscard]] std::array<T, 3> tip(const T* free, const double* encoder_rad) const {
    const std::size_t n = joints_.size();
    const std::size_t tip = n + 5 * (n - 1);
    std::array<T, 3> p{number(tip, free), number(tip + 1, free), number(tip + 2, free)};
    for (std::size_t i = n; i-- > 0;) {
      if (i + 1 < n) step_back(n + 5 * i, free, p);
      const T angle = joint_angle(i, free, encoder_rad[i]);
      turn(angle, p[0], p[1]);
    }
    const Eigen::Matrix3d& R = base_.rotation;
    const Eigen::Vector3d& t = base_.translation_mm;
    return {R(0, 0) * p[0] + R(0, 1) * p[1] + R(0, 2) * p[2] + t(0),
            R(1, 0) * p[0] + R(1, 1) * p[1] + R(1, 2) * p[2] + t(1),
            R(2, 0) * p[0] + R(2, 1) * p[1] + R(2, 2) * p[2] + t(2)};
  }

 private:
  struct Number {
    double value = 0.0;
    int place = -1;  // among the free ones
  };
  struct JointNumbers {
    int direction = 1;
    std::size_t harmonics = 0;
    std::size_t first_harmonic = 0;
  };

  // A held number stays plain: arithmetic with automatic derivatives is dear.
  template <class T, class Use>
  void with(std::size_t index, const T* free, const Use& use) const {
    const Number& number = numbers_[index];
    if (number.place < 0) {
      if (number.value != 0.0) use(number.value);
    } else {
      use(free[number.place]);
    }
  }
  template <class T>
  [[nodiscard]] T number(std::size_t index, const T* free) const {
    const Number& number = numbers_[index];
    return number.place < 0 ? T(number.value) : free[number.place];
  }

  template <class T, class Angle>
  static void turn(const Angle& angle, T& u, T& v) {
    using std::cos;
    using std::sin;
    const Angle c = cos(angle);
    const Angle s = sin(angle);
    const T turned = c * u - s * v;
    v = s * u + c * v;
    u = turned;
  }

  template <class T>
  void step_back(std::size_t link, const T* free, std::array<T, 3>& p) const {
    with(link + 4, free, [&](const auto& beta) { turn(beta, p[2], p[0]); });
    with(link + 3, free, [&](const auto& alpha) { turn(alpha, p[1], p[2]); });
    with(link + 2, free, [&](const auto& a) { p[0] += a; });
    with(link + 1, free, [&](const auto& b) { p[1] += b; });
    with(link, free, [&](const auto& d) { p[2] += d; });
  }

  template <class T>
  [[nodiscard]] T joint_angle(std::size_t i, const T* free, double encoder_rad) const {
    const JointNumbers& joint = joints_[i];
    T angle = static_cast<double>(joint.direction) * (number(i, free) + encoder_rad);
    for (std::size_t k = 0; k < joint.harmonics; ++k) {
      const double multiple = static_cast<double>(k + 1) * encoder_rad;
      const std::size_t at = joint.first_harmonic + 2 * k;
      with(at, free, [&](const auto& cosine) { angle += cosine * std::cos(multiple); });
      with(at + 1, free, [&](const auto& sine) { angle += sine * std::sin(multiple); });
    }
    return angle;
  }

  RigidTransform base_;
  std::vector<Number> numbers_;
  std::vector<JointNumbers> joints_;
};

}  // namespace armcal::testing
