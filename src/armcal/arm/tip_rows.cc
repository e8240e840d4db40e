// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/tip_rows.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/invariant.h"
#include "armcal/numerics/gram_kernel.h"

namespace armcal {
// How wide vectors are is the processor's affair: the kernel is written for any vector type and
// compiled for three. Every lane sees the same operations in the same order, so all give the same
// digits (no contraction, see the build). A vector wider than the instructions of its function
// would be kept in memory: docs/decisions/vector-kernels.md.
#define ARMCAL_INLINE [[gnu::always_inline]] inline

template <class Pack>
class TipKernel {
 public:
  static constexpr Eigen::Index kWidth = sizeof(Pack) / sizeof(double);

  ARMCAL_INLINE static void fill(const TipRows& rows, const PosturePacks& postures,
                                 Eigen::Index pack, Eigen::Index lanes,
                                 const TipRows::Target& target) {
    for (Eigen::Index lane = 0; lane < lanes; lane += kWidth) {
      TipRows::Target here = target;
      here.tips += 3 * lane;
      if (here.rows != nullptr) here.rows += target.rows_per_posture * lane * target.stride;
      TipKernel(rows, postures, pack, lane, std::min(kWidth, lanes - lane)).run(here);
    }
  }

 private:
  struct Vector {
    Pack x, y, z;
  };

  ARMCAL_INLINE TipKernel(const TipRows& rows, const PosturePacks& postures, Eigen::Index pack,
                          Eigen::Index lane, Eigen::Index lanes)
      : rows_(rows), postures_(postures), pack_(pack), lane_(lane), lanes_(lanes) {}

  ARMCAL_INLINE static void set(Pack& pack, double value) {
    for (Eigen::Index l = 0; l < kWidth; ++l) pack[l] = value;
  }
  ARMCAL_INLINE static void set(Vector& v, const Eigen::Vector3d& value) {
    set(v.x, value.x());
    set(v.y, value.y());
    set(v.z, value.z());
  }
  ARMCAL_INLINE static void cross(Vector& out, const Vector& a, const Vector& b) {
    out.x = a.y * b.z - a.z * b.y;
    out.y = a.z * b.x - a.x * b.z;
    out.z = a.x * b.y - a.y * b.x;
  }
  // (first, second) turned: first' = c first + s second, second' = c second - s first.
  ARMCAL_INLINE static void turn(Vector& first, Vector& second, const Pack& c, const Pack& s) {
    const Vector old = first;
    first.x = c * old.x + s * second.x;
    first.y = c * old.y + s * second.y;
    first.z = c * old.z + s * second.z;
    second.x = c * second.x - s * old.x;
    second.y = c * second.y - s * old.y;
    second.z = c * second.z - s * old.z;
  }

  ARMCAL_INLINE void load(Pack& sine, Pack& cosine, int joint) const {
    const double* values = postures_.at(pack_, joint) + lane_;
    for (Eigen::Index l = 0; l < kWidth; ++l) {
      sine[l] = values[l];
      cosine[l] = values[kLanes + l];
    }
  }

  // Cosine and sine of (order) e from those of e, by the addition theorem.
  ARMCAL_INLINE static void next_multiple(Pack& ck, Pack& sk, const Pack& c, const Pack& s) {
    const Pack cosine = ck * c - sk * s;
    sk = sk * c + ck * s;
    ck = cosine;
  }

  // Adds a small angle h (by its series; a large one by the library) to an angle given by cosine
  // and sine.
  ARMCAL_INLINE static void add_angle(Pack& c, Pack& s, const Pack& h) {
    // Harmonics are errors of an encoder, far below this; where they are not the series would lose
    // digits.
    constexpr double kLargestSeriesAngle = 0.05;
    bool small = true;
    for (Eigen::Index l = 0; l < kWidth; ++l) small = small && std::abs(h[l]) < kLargestSeriesAngle;
    const Pack q = h * h;
    Pack sh = h * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0 * (1.0 - q / 72.0))));
    Pack ch =
        1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0 * (1.0 - q / 90.0))));
    for (Eigen::Index l = 0; !small && l < kWidth; ++l) {
      sh[l] = std::sin(h[l]);
      ch[l] = std::cos(h[l]);
    }
    const Pack cosine = c * ch - s * sh;
    s = s * ch + c * sh;
    c = cosine;
  }

  ARMCAL_INLINE void joint_turn(std::size_t i, Pack& c, Pack& s) const {
    const TipRows::PreparedJoint& joint = rows_.joints_[i];
    Pack sin_e;
    Pack cos_e;
    load(sin_e, cos_e, static_cast<int>(i));
    const Pack sin_turned = joint.direction * sin_e;
    s = sin_turned * joint.cos_zero + cos_e * joint.sin_zero;
    c = cos_e * joint.cos_zero - sin_turned * joint.sin_zero;
    if (joint.harmonics.empty()) return;
    Pack ck = cos_e;
    Pack sk = sin_e;
    Pack h = joint.harmonics[0].cos_rad * ck + joint.harmonics[0].sin_rad * sk;
    for (std::size_t k = 1; k < joint.harmonics.size(); ++k) {
      next_multiple(ck, sk, cos_e, sin_e);
      h += joint.harmonics[k].cos_rad * ck + joint.harmonics[k].sin_rad * sk;
    }
    add_angle(c, s, h);
  }

  // From base to tip; what the derivatives need is kept of every joint.
  ARMCAL_INLINE void sweep() {
    Vector o;
    Vector x;
    Vector y;
    Vector z;
    set(o, rows_.base_.translation_mm);
    set(x, rows_.base_.rotation.col(0));
    set(y, rows_.base_.rotation.col(1));
    set(z, rows_.base_.rotation.col(2));
    const std::size_t n = rows_.joints_.size();
    for (std::size_t i = 0; i < n; ++i) {
      Pack c;
      Pack s;
      joint_turn(i, c, s);
      axis_[i] = z;
      origin_[i] = o;
      turn(x, y, c, s);
      x_[i] = x;
      y_[i] = y;
      if (i + 1 == n) break;
      const TipRows::PreparedLink& link = rows_.links_[i];
      shift(o, link.a, x, link.b, y, link.d, z);
      set(c, link.cos_alpha);
      set(s, link.sin_alpha);
      turn(y, z, c, s);
      y_turned_[i] = y;
      if (link.sin_beta != 0.0) {
        set(c, link.cos_beta);
        set(s, link.sin_beta);
        turn(z, x, c, s);
      }
    }
    tip_ = o;
    shift(tip_, rows_.tip_.a_mm, x, rows_.tip_.b_mm, y, rows_.tip_.d_mm, z);
  }
  ARMCAL_INLINE static void shift(Vector& o, double a, const Vector& x, double b, const Vector& y,
                                  double d, const Vector& z) {
    o.x += a * x.x + b * y.x + d * z.x;
    o.y += a * x.y + b * y.y + d * z.y;
    o.z += a * x.z + b * y.z + d * z.z;
  }

  ARMCAL_INLINE void store(const TipRows::Target& target, std::size_t column,
                           const Vector& v) const {
    double* place = target.rows + column;
    for (Eigen::Index l = 0; l < lanes_; ++l) {
      place[0] = v.x[l];
      place[target.stride] = v.y[l];
      place[2 * target.stride] = v.z[l];
      place += target.rows_per_posture * target.stride;
    }
  }

  // Derivative by a turn about `axis` through the origin of a joint.
  ARMCAL_INLINE void by_turn(Vector& out, const Vector& axis, std::size_t joint) const {
    Vector lever;
    lever.x = tip_.x - origin_[joint].x;
    lever.y = tip_.y - origin_[joint].y;
    lever.z = tip_.z - origin_[joint].z;
    cross(out, axis, lever);
  }

  ARMCAL_INLINE void by_encoder(Vector& out, const TipColumn& column) const {
    const auto i = static_cast<std::size_t>(column.joint);
    by_turn(out, axis_[i], i);
    Pack factor;
    set(factor, rows_.joints_[i].direction);
    if (column.harmonic > 0) {
      Pack sin_e;
      Pack cos_e;
      load(sin_e, cos_e, column.joint);
      Pack ck = cos_e;
      Pack sk = sin_e;
      for (int order = 1; order < column.harmonic; ++order) next_multiple(ck, sk, cos_e, sin_e);
      factor = column.kind == ParameterKind::cosine ? ck : sk;
    }
    out.x *= factor;
    out.y *= factor;
    out.z *= factor;
  }

  ARMCAL_INLINE void run(const TipRows::Target& target) {
    sweep();
    for (Eigen::Index l = 0; l < lanes_; ++l) {
      target.tips[3 * l] = tip_.x[l];
      target.tips[3 * l + 1] = tip_.y[l];
      target.tips[3 * l + 2] = tip_.z[l];
    }
    if (target.rows == nullptr) return;
    for (std::size_t c = 0; c < rows_.columns_.size(); ++c) {
      const TipColumn& column = rows_.columns_[c];
      const auto i = static_cast<std::size_t>(column.joint);
      Vector v;
      switch (column.kind) {
        case ParameterKind::d:
        case ParameterKind::tip_d:
          v = axis_[i];
          break;
        case ParameterKind::b:
        case ParameterKind::tip_b:
          v = y_[i];
          break;
        case ParameterKind::a:
        case ParameterKind::tip_a:
          v = x_[i];
          break;
        case ParameterKind::alpha:
          by_turn(v, x_[i], i + 1);
          break;
        case ParameterKind::beta:
          by_turn(v, y_turned_[i], i + 1);
          break;
        case ParameterKind::zero:
        case ParameterKind::cosine:
        case ParameterKind::sine:
          by_encoder(v, column);
          break;
      }
      store(target, c, v);
    }
  }

  const TipRows& rows_;
  const PosturePacks& postures_;
  Eigen::Index pack_, lane_, lanes_;
  Vector tip_;
  std::array<Vector, kMaxJoints> axis_;  // z of the joint
  std::array<Vector, kMaxJoints> origin_;
  std::array<Vector, kMaxJoints> x_, y_;     // after the joint's turn
  std::array<Vector, kMaxJoints> y_turned_;  // y after alpha: the axis of beta
};

namespace {

using Pack2 [[gnu::vector_size(16)]] = double;
void fill_by_two(const TipRows& rows, const PosturePacks& postures, Eigen::Index pack,
                 Eigen::Index lanes, const TipRows::Target& target) {
  TipKernel<Pack2>::fill(rows, postures, pack, lanes, target);
}

#if defined(__x86_64__) && defined(__GNUC__)
using Pack4 [[gnu::vector_size(32)]] = double;
using Pack8 [[gnu::vector_size(64)]] = double;
[[gnu::target("avx2")]] void fill_by_four(const TipRows& rows, const PosturePacks& postures,
                                          Eigen::Index pack, Eigen::Index lanes,
                                          const TipRows::Target& target) {
  TipKernel<Pack4>::fill(rows, postures, pack, lanes, target);
}
[[gnu::target("avx512f")]] void fill_by_eight(const TipRows& rows, const PosturePacks& postures,
                                              Eigen::Index pack, Eigen::Index lanes,
                                              const TipRows::Target& target) {
  TipKernel<Pack8>::fill(rows, postures, pack, lanes, target);
}
#endif

}  // namespace

PosturePacks::PosturePacks(const Eigen::MatrixXd& encoder_rad)
    : joint_count_(static_cast<int>(encoder_rad.rows())), count_(encoder_rad.cols()) {
  const Eigen::Index packs = (count_ + kLanes - 1) / kLanes;
  values_.resize(static_cast<std::size_t>(2 * kLanes * packs * joint_count_));
  for (Eigen::Index p = 0; p < packs; ++p) {
    for (int joint = 0; joint < joint_count_; ++joint) {
      double* place = values_.data() + 2 * kLanes * (p * joint_count_ + joint);
      for (Eigen::Index l = 0; l < kLanes; ++l) {
        const double e = encoder_rad(joint, std::min(p * kLanes + l, count_ - 1));
        place[l] = std::sin(e);
        place[kLanes + l] = std::cos(e);
      }
    }
  }
}

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

void TipRows::fill(const PosturePacks& postures, Eigen::Index first, Eigen::Index count,
                   const Target& target) const {
  ARMCAL_INVARIANT(first % kLanes == 0 && first + count <= postures.count());
  ARMCAL_INVARIANT(postures.joint_count() == static_cast<int>(joints_.size()));
  auto fill = fill_by_two;
#if defined(__x86_64__) && defined(__GNUC__)
  const VectorWidth width = widest_vectors();
  if (width == VectorWidth::four) fill = fill_by_four;
  if (width == VectorWidth::eight) fill = fill_by_eight;
#endif
  for (Eigen::Index done = 0; done < count; done += kLanes) {
    Target here = target;
    here.tips += 3 * done;
    if (here.rows != nullptr) here.rows += target.rows_per_posture * done * target.stride;
    fill(*this, postures, (first + done) / kLanes, std::min(kLanes, count - done), here);
  }
}

}  // namespace armcal
