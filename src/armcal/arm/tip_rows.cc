// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/tip_rows.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/invariant.h"

namespace armcal {
namespace {

#define ARMCAL_INLINE inline __attribute__((always_inline))

struct PackVector {
  Pack x, y, z;
};

ARMCAL_INLINE void copy_scaled(PackVector& out, const Pack& c, const PackVector& a, const Pack& s,
                               const PackVector& b) {
  out.x = c * a.x + s * b.x;
  out.y = c * a.y + s * b.y;
  out.z = c * a.z + s * b.z;
}

ARMCAL_INLINE void cross(PackVector& out, const PackVector& a, const PackVector& b) {
  out.x = a.y * b.z - a.z * b.y;
  out.y = a.z * b.x - a.x * b.z;
  out.z = a.x * b.y - a.y * b.x;
}

ARMCAL_INLINE void fill(Pack& pack, double value) {
  for (std::ptrdiff_t l = 0; l < kLanes; ++l) pack[l] = value;
}

ARMCAL_INLINE void fill(PackVector& v, const Eigen::Vector3d& value) {
  fill(v.x, value.x());
  fill(v.y, value.y());
  fill(v.z, value.z());
}

// (first, second) turned: first' = c first + s second, second' = c second - s first.
ARMCAL_INLINE void turn(PackVector& first, PackVector& second, const Pack& c, const Pack& s) {
  PackVector turned;
  copy_scaled(turned, c, first, s, second);
  copy_scaled(second, c, second, -s, first);
  first = turned;
}

// Cosine and sine of k e for k = 1, 2, .. by the addition theorem.
struct Multiples {
  Pack cosine, sine;
};

ARMCAL_INLINE void next_multiple(Multiples& at, const Pack& c, const Pack& s) {
  const Pack cosine = at.cosine * c - at.sine * s;
  at.sine = at.sine * c + at.cosine * s;
  at.cosine = cosine;
}

// Harmonics are errors of an encoder, far below this; where they are not the series would lose
// digits.
constexpr double kLargestSeriesAngle = 0.05;

// Adds the angle h (a small one, by series; else by the library, lane by lane) to an angle given by
// cosine and sine.
ARMCAL_INLINE void add_angle(Pack& c, Pack& s, const Pack& h) {
  bool small = true;
  for (std::ptrdiff_t l = 0; l < kLanes; ++l) small = small && std::abs(h[l]) < kLargestSeriesAngle;
  Pack ch;
  Pack sh;
  if (small) {
    const Pack q = h * h;
    sh = h * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0))));
    ch = 1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0 * (1.0 - q / 90.0))));
  } else {
    for (std::ptrdiff_t l = 0; l < kLanes; ++l) {
      sh[l] = std::sin(h[l]);
      ch[l] = std::cos(h[l]);
    }
  }
  const Pack cosine = c * ch - s * sh;
  s = s * ch + c * sh;
  c = cosine;
}

}  // namespace

PosturePacks::PosturePacks(const Eigen::MatrixXd& encoder_rad)
    : joint_count_(static_cast<int>(encoder_rad.rows())), count_(encoder_rad.cols()) {
  const Eigen::Index packs = (count_ + kLanes - 1) / kLanes;
  at_.resize(static_cast<std::size_t>(2 * packs * joint_count_));
  for (Eigen::Index p = 0; p < packs; ++p) {
    for (int joint = 0; joint < joint_count_; ++joint) {
      const auto place = static_cast<std::size_t>(2 * (p * joint_count_ + joint));
      for (Eigen::Index l = 0; l < kLanes; ++l) {
        const double e = encoder_rad(joint, std::min(p * kLanes + l, count_ - 1));
        at_[place][l] = std::sin(e);
        at_[place + 1][l] = std::cos(e);
      }
    }
  }
}

// What the forward sweep leaves behind of every joint.
struct TipRows::Frames {
  std::array<PackVector, kMaxJoints> axis;      // z before the joint turns (and after: the same)
  std::array<PackVector, kMaxJoints> origin;    // of the joint
  std::array<PackVector, kMaxJoints> x, y;      // after the joint's turn
  std::array<PackVector, kMaxJoints> y_turned;  // y after alpha: the axis of beta
};

std::vector<TipColumn> tip_columns(const ParameterTable& table, std::span<const int> parameters) {
  std::vector<TipColumn> columns;
  for (const int index : parameters) {
    const Parameter& parameter = table[index];
    const bool of_joint = parameter.kind == ParameterKind::zero ||
                          parameter.kind == ParameterKind::cosine ||
                          parameter.kind == ParameterKind::sine;
    // A link is named after the joint that it leads to, the tip as if it led to one more.
    columns.push_back(
        {parameter.kind, of_joint ? parameter.joint - 1 : parameter.joint - 2, parameter.harmonic});
  }
  return columns;
}

TipRows::TipRows(const ArmModel& arm, std::span<const TipColumn> columns)
    : base_(arm.base_from_first_joint), tip_(arm.tip), columns_(columns.begin(), columns.end()) {
  const auto problems = problems_of(arm);
  if (!problems.empty()) throw std::invalid_argument(problems.front());
  for (const Joint& joint : arm.joints) {
    const double zero = joint.direction * joint.zero_rad;
    joints_.push_back(
        {static_cast<double>(joint.direction), std::sin(zero), std::cos(zero), joint.harmonics});
  }
  for (const Link& link : arm.links) {
    links_.push_back({link.d_mm, link.b_mm, link.a_mm, std::cos(link.alpha_rad),
                      std::sin(link.alpha_rad), std::cos(link.beta_rad), std::sin(link.beta_rad)});
  }
}

ARMCAL_FOR_EVERY_PROCESSOR
void TipRows::fill_pack(const TipRows& self, const PosturePacks& postures, Eigen::Index pack,
                        Eigen::Index lanes, const Target& target) {
  const auto n = self.joints_.size();
  Frames at;
  PackVector o;
  PackVector x;
  PackVector y;
  PackVector z;
  armcal::fill(o, self.base_.translation_mm);
  armcal::fill(x, self.base_.rotation.col(0));
  armcal::fill(y, self.base_.rotation.col(1));
  armcal::fill(z, self.base_.rotation.col(2));
  for (std::size_t i = 0; i < n; ++i) {
    const PreparedJoint& joint = self.joints_[i];
    const Pack& sin_e = postures.sine(pack, static_cast<int>(i));
    const Pack& cos_e = postures.cosine(pack, static_cast<int>(i));
    const Pack sin_turned = joint.direction * sin_e;
    Pack s = sin_turned * joint.cos_zero + cos_e * joint.sin_zero;
    Pack c = cos_e * joint.cos_zero - sin_turned * joint.sin_zero;
    if (!joint.harmonics.empty()) {
      Multiples k{cos_e, sin_e};
      Pack h = joint.harmonics[0].cos_rad * k.cosine + joint.harmonics[0].sin_rad * k.sine;
      for (std::size_t j = 1; j < joint.harmonics.size(); ++j) {
        next_multiple(k, cos_e, sin_e);
        h += joint.harmonics[j].cos_rad * k.cosine + joint.harmonics[j].sin_rad * k.sine;
      }
      add_angle(c, s, h);
    }
    at.axis[i] = z;
    at.origin[i] = o;
    turn(x, y, c, s);
    at.x[i] = x;
    at.y[i] = y;
    if (i + 1 == n) break;
    const PreparedLink& link = self.links_[i];
    o.x += link.a * x.x + link.b * y.x + link.d * z.x;
    o.y += link.a * x.y + link.b * y.y + link.d * z.y;
    o.z += link.a * x.z + link.b * y.z + link.d * z.z;
    Pack cosine;
    Pack sine;
    armcal::fill(cosine, link.cos_alpha);
    armcal::fill(sine, link.sin_alpha);
    turn(y, z, cosine, sine);
    at.y_turned[i] = y;
    if (link.sin_beta != 0.0) {
      armcal::fill(cosine, link.cos_beta);
      armcal::fill(sine, link.sin_beta);
      turn(z, x, cosine, sine);
    }
  }
  PackVector p;
  p.x = o.x + (self.tip_.a_mm * x.x + self.tip_.b_mm * y.x + self.tip_.d_mm * z.x);
  p.y = o.y + (self.tip_.a_mm * x.y + self.tip_.b_mm * y.y + self.tip_.d_mm * z.y);
  p.z = o.z + (self.tip_.a_mm * x.z + self.tip_.b_mm * y.z + self.tip_.d_mm * z.z);
  for (Eigen::Index l = 0; l < lanes; ++l) {
    target.tips[3 * l] = p.x[l];
    target.tips[3 * l + 1] = p.y[l];
    target.tips[3 * l + 2] = p.z[l];
  }
  if (target.rows == nullptr) return;

  const auto store = [&](std::size_t column, const PackVector& v) __attribute__((always_inline)) {
    double* place = target.rows + column;
    for (Eigen::Index l = 0; l < lanes; ++l) {
      place[0] = v.x[l];
      place[target.stride] = v.y[l];
      place[2 * target.stride] = v.z[l];
      place += target.rows_per_posture * target.stride;
    }
  };
  const auto lever_to_tip = [&](std::size_t joint) __attribute__((always_inline)) {
    return PackVector{p.x - at.origin[joint].x, p.y - at.origin[joint].y, p.z - at.origin[joint].z};
  };
  for (std::size_t c = 0; c < self.columns_.size(); ++c) {
    const TipColumn& column = self.columns_[c];
    const auto i = static_cast<std::size_t>(column.joint);
    PackVector v;
    switch (column.kind) {
      case ParameterKind::d:
      case ParameterKind::tip_d:
        store(c, at.axis[i]);
        break;
      case ParameterKind::b:
      case ParameterKind::tip_b:
        store(c, at.y[i]);
        break;
      case ParameterKind::a:
      case ParameterKind::tip_a:
        store(c, at.x[i]);
        break;
      case ParameterKind::alpha:
        cross(v, at.x[i], lever_to_tip(i + 1));
        store(c, v);
        break;
      case ParameterKind::beta:
        cross(v, at.y_turned[i], lever_to_tip(i + 1));
        store(c, v);
        break;
      case ParameterKind::zero:
      case ParameterKind::cosine:
      case ParameterKind::sine: {
        cross(v, at.axis[i], lever_to_tip(i));
        Pack factor;
        armcal::fill(factor, self.joints_[i].direction);
        if (column.harmonic > 0) {
          const Pack& cos_e = postures.cosine(pack, column.joint);
          const Pack& sin_e = postures.sine(pack, column.joint);
          Multiples k{cos_e, sin_e};
          for (int order = 1; order < column.harmonic; ++order) next_multiple(k, cos_e, sin_e);
          factor = column.kind == ParameterKind::cosine ? k.cosine : k.sine;
        }
        v.x *= factor;
        v.y *= factor;
        v.z *= factor;
        store(c, v);
        break;
      }
    }
  }
}

void TipRows::fill(const PosturePacks& postures, Eigen::Index first, Eigen::Index count,
                   const Target& target) const {
  ARMCAL_INVARIANT(first % kLanes == 0 && first + count <= postures.count());
  ARMCAL_INVARIANT(postures.joint_count() == static_cast<int>(joints_.size()));
  for (Eigen::Index done = 0; done < count; done += kLanes) {
    Target here = target;
    here.tips += 3 * done;
    if (here.rows != nullptr) here.rows += target.rows_per_posture * done * target.stride;
    fill_pack(*this, postures, (first + done) / kLanes,
              std::min<Eigen::Index>(kLanes, count - done), here);
  }
}

}  // namespace armcal
