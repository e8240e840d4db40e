// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Forward kinematics of a six-joint arm, one thread, against Orocos KDL in the same run: time per
// pose, allocations per pose, and first that both give the same tips.
#include <benchmark/benchmark.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <new>
#include <numbers>
#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

constexpr int kPoses = 4096;

// The consistent ROMER arm with small errors everywhere, so that no number is a friendly zero.
armcal::ArmModel example_arm() {
  armcal::RandomStream random(1);
  armcal::ArmModel arm;
  arm.joints.resize(6);
  arm.links.resize(5);
  for (std::size_t i = 0; i < 5; ++i) {
    arm.links[i].alpha_rad = (i % 2 == 0 ? 0.5 : -0.5) * std::numbers::pi + 1e-3 * random.normal();
    arm.links[i].d_mm = 0.1 * random.normal();
    arm.links[i].b_mm = i == 1 ? 747.489 : i == 3 ? 531.880 : 0.1 * random.normal();
    arm.links[i].a_mm = i == 3 ? 78.312 : 0.1 * random.normal();
  }
  for (armcal::Joint& joint : arm.joints) joint.zero_rad = 1e-3 * random.normal();
  arm.tip = {.a_mm = -25.962, .b_mm = 176.484, .d_mm = 0.1};
  return arm;
}

// One segment per joint: RotZ at its root, then the constant part of the link.
KDL::Chain kdl_chain(const armcal::ArmModel& arm) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < 6; ++i) {
    KDL::Frame rest;
    if (i < 5) {
      const armcal::Link& link = arm.links[i];
      rest = KDL::Frame(KDL::Rotation::RotX(link.alpha_rad),
                        KDL::Vector(link.a_mm, link.b_mm, link.d_mm));
    } else {
      rest = KDL::Frame(KDL::Vector(arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm));
    }
    // KDL counts the joint's angle before the frame: the zero offset is a constant turn in front of
    // it.
    const KDL::Frame zero(KDL::Rotation::RotZ(arm.joints[i].zero_rad));
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), zero * rest));
  }
  return chain;
}

struct Poses {
  Poses() {
    armcal::RandomStream random(2);
    for (double& angle : angles) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  }
  [[nodiscard]] std::span<const double> operator[](int i) const {
    return std::span(angles).subspan(static_cast<std::size_t>(6 * i), 6);
  }
  std::vector<double> angles = std::vector<double>(6 * kPoses);
};

const armcal::ArmModel kArm = example_arm();
const Poses kPostures;

void check_agreement() {
  const armcal::ForwardKinematics ours(kArm);
  const KDL::Chain chain = kdl_chain(kArm);
  KDL::ChainFkSolverPos_recursive theirs(chain);
  double worst = 0.0;
  for (int i = 0; i < kPoses; ++i) {
    KDL::JntArray q(6);
    for (unsigned j = 0; j < 6; ++j) q(j) = kPostures[i][j];
    KDL::Frame frame;
    theirs.JntToCart(q, frame);
    const Eigen::Vector3d tip = ours.tip_in_base(kPostures[i]);
    worst = std::max(worst, (tip - Eigen::Vector3d(frame.p.x(), frame.p.y(), frame.p.z())).norm());
  }
  std::printf("largest difference of tips over %d poses: %.1e mm\n", kPoses, worst);
  if (worst > 1e-9) {
    std::printf("armcal and KDL disagree: nothing to compare\n");
    std::exit(1);
  }
}

void count_allocations(benchmark::State& state, long before) {
  state.counters["allocations_per_pose"] = benchmark::Counter(
      static_cast<double>(allocations.load() - before), benchmark::Counter::kAvgIterations);
}

void armcal_tip(benchmark::State& state) {
  const armcal::ForwardKinematics kinematics(kArm);
  const long before = allocations.load();
  int i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(kinematics.tip_in_base(kPostures[i]));
    i = (i + 1) % kPoses;
  }
  count_allocations(state, before);
}

void kdl_tip(benchmark::State& state) {
  const KDL::Chain chain = kdl_chain(kArm);
  KDL::ChainFkSolverPos_recursive solver(chain);
  std::vector<KDL::JntArray> postures(kPoses, KDL::JntArray(6));
  for (int i = 0; i < kPoses; ++i) {
    for (unsigned j = 0; j < 6; ++j) postures[static_cast<std::size_t>(i)](j) = kPostures[i][j];
  }
  KDL::Frame frame;
  const long before = allocations.load();
  std::size_t i = 0;
  for (auto _ : state) {
    solver.JntToCart(postures[i], frame);
    benchmark::DoNotOptimize(frame);
    i = (i + 1) % kPoses;
  }
  count_allocations(state, before);
}

void armcal_tip_and_jacobian(benchmark::State& state) {
  const armcal::ForwardKinematics kinematics(kArm);
  armcal::TipLinearisation workspace = kinematics.linearise(kPostures[0]);
  const long before = allocations.load();
  int i = 0;
  for (auto _ : state) {
    kinematics.linearise(kPostures[i], workspace);
    benchmark::DoNotOptimize(workspace.J_tip_parameters.data());
    i = (i + 1) % kPoses;
  }
  count_allocations(state, before);
}

BENCHMARK(armcal_tip);
BENCHMARK(kdl_tip);
BENCHMARK(armcal_tip_and_jacobian);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  check_agreement();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
