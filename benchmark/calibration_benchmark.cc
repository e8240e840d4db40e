// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Calibration of a six-joint arm from reference points in one unknown set-up: 21 geometric numbers,
// six harmonics, six of the frame. One thread, against Ceres and its TinySolver in the same run, to
// the same stop (relative change of the cost 1e-12); first that all find the same optimum. Building
// the problem from readings in memory counts; reading files and choosing unknowns do not.
//
// CPU time of the calling thread, so that a busy machine disturbs little.
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <ceres/tiny_solver.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/identification/calibration.h"
#include "armcal/identification/estimation_problem.h"
#include "armcal/testing/second_kinematics.h"
#include "armcal/testing/wang2016_arm.h"

namespace {

using armcal::ArmModel;
using armcal::RandomStream;
using armcal::RigidTransform;
using Eigen::Index;

constexpr int kJoints = 6;
constexpr int kArmUnknowns = 27;
constexpr int kUnknowns = kArmUnknowns + 6;
constexpr double kRelativeDecrease = 1e-12;
constexpr double kNoise_mm = 0.01;
using Numbers =
    Eigen::Matrix<double, kUnknowns, 1>;  // free ones of the arm, rotation vector, shift

Eigen::Vector3d random_vector(RandomStream& random, double sigma) {
  const double x = random.normal();
  const double y = random.normal();
  return sigma * Eigen::Vector3d(x, y, random.normal());
}

// The arm of the 2016 paper as a catalogue gives it.
ArmModel nominal_arm() {
  ArmModel arm = armcal::testing::nominal_romer();
  for (const std::size_t joint : {1U, 2U, 3U}) arm.joints[joint].harmonics.resize(1);
  return arm;
}

ArmModel true_arm(RandomStream& random) {
  ArmModel arm = nominal_arm();
  for (armcal::Joint& joint : arm.joints) {
    joint.zero_rad += 2e-3 * random.normal();
    for (armcal::Harmonic& harmonic : joint.harmonics) {
      harmonic = {1e-4 * random.normal(), 1e-4 * random.normal()};
    }
  }
  for (armcal::Link& link : arm.links) {
    link.alpha_rad += 2e-3 * random.normal();
    for (double* length : {&link.d_mm, &link.b_mm, &link.a_mm}) *length += 0.5 * random.normal();
  }
  for (double* length : {&arm.tip.a_mm, &arm.tip.b_mm, &arm.tip.d_mm}) {
    *length += 0.5 * random.normal();
  }
  return arm;
}

// Readings in memory and where everybody starts.
struct Input {
  ArmModel nominal = nominal_arm();
  std::vector<int> free;
  armcal::ObservationGroup group;
  RigidTransform start_frame;  // reference_from_base

  explicit Input(int poses) {
    RandomStream random(7, static_cast<std::uint64_t>(poses));
    const armcal::ForwardKinematics arm(true_arm(random));
    const RigidTransform frame{armcal::rotation_from_vector({0.3, -0.5, 0.4}), {400, -300, 200}};
    start_frame = {armcal::rotation_from_vector(random_vector(random, 0.01)) * frame.rotation,
                   frame.translation_mm + random_vector(random, 5.0)};
    group.name = "points";
    group.file = "points.csv";
    group.encoder_rad.resize(kJoints, poses);
    group.reference_mm.resize(3, poses);
    group.u_mm = Eigen::VectorXd::Constant(poses, kNoise_mm);
    group.is_check.assign(static_cast<std::size_t>(poses), false);
    group.place.assign(static_cast<std::size_t>(poses), "A");
    for (int i = 0; i < poses; ++i) {
      group.lines.push_back(i + 2);
      for (double& angle : group.encoder_rad.col(i)) {
        angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      }
      const Eigen::Vector3d tip =
          arm.tip_in_base({group.encoder_rad.col(i).data(), static_cast<std::size_t>(kJoints)});
      group.reference_mm.col(i) = frame * tip + random_vector(random, kNoise_mm);
    }
  }

  [[nodiscard]] Index count() const { return group.count(); }

  [[nodiscard]] Numbers start() const {
    const armcal::ParameterTable table(nominal);
    Numbers x;
    for (std::size_t i = 0; i < free.size(); ++i) {
      x(static_cast<Index>(i)) = table[free[i]].nominal;
    }
    x.segment<3>(kArmUnknowns) = armcal::vector_from_rotation(start_frame.rotation);
    x.tail<3>() = start_frame.translation_mm;
    return x;
  }
};

// What the readings determine, as a calibration finds it once.
std::vector<int> free_parameters() {
  const Input input(300);
  const armcal::Calibration result =
      armcal::calibrate(input.nominal, {&input.group, 1}, {.hold = {"beta*"}});
  if (!result.ok() || result.free.size() != kArmUnknowns) {
    std::printf("%zu parameters are free, not %d: nothing to compare\n", result.free.size(),
                kArmUnknowns);
    std::exit(1);
  }
  return result.free;
}

// --- armcal ------------------------------------------------------------------------------------

Numbers by_armcal(const Input& input) {
  armcal::Unknowns unknowns(input.nominal, input.free);
  const auto residuals = armcal::residuals_of(input.group, false, unknowns);
  const int setup = *unknowns.find("setup.A", armcal::NuisanceKind::frame);
  unknowns[setup].pivot_mm = input.group.reference_mm.rowwise().mean();
  Eigen::VectorXd start = unknowns.start();
  unknowns.set_frame(start, setup, input.start_frame);
  std::vector<const armcal::Residual*> pointers;
  for (const auto& residual : residuals) pointers.push_back(residual.get());
  const armcal::EstimationProblem problem(pointers, unknowns, {});
  const auto solution =
      armcal::solve_least_squares(problem, start,
                                  {.relative_decrease = kRelativeDecrease,
                                   .residual_resolution = problem.residual_resolution()});
  Numbers x;
  x.head<kArmUnknowns>() = solution.x.head<kArmUnknowns>();
  const RigidTransform frame = unknowns.frame(solution.x, setup);
  x.segment<3>(kArmUnknowns) = armcal::vector_from_rotation(frame.rotation);
  x.tail<3>() = frame.translation_mm;
  return x;
}

// --- Ceres -------------------------------------------------------------------------------------

struct PointOfPose {
  const armcal::testing::SecondKinematics* arm;
  const double* encoder_rad;
  const double* reference_mm;
  double weight;

  template <class T>
  bool operator()(const T* x, T* residual) const {
    const std::array<T, 3> tip = arm->tip(x, encoder_rad);
    ceres::AngleAxisRotatePoint(x + kArmUnknowns, tip.data(), residual);
    for (int c = 0; c < 3; ++c) {
      residual[c] = weight * (residual[c] + x[kArmUnknowns + 3 + c] - reference_mm[c]);
    }
    return true;
  }
};

ceres::Solver::Options ceres_options(ceres::LinearSolverType solver) {
  ceres::Solver::Options options;
  options.linear_solver_type = solver;
  options.function_tolerance = kRelativeDecrease;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.logging_type = ceres::SILENT;
  return options;
}

Numbers by_ceres_autodiff(const Input& input, ceres::LinearSolverType solver) {
  const armcal::testing::SecondKinematics arm(input.nominal, input.free);
  Numbers x = input.start();
  ceres::Problem problem;
  for (Index i = 0; i < input.count(); ++i) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PointOfPose, 3, kUnknowns>(
            new PointOfPose{&arm, input.group.encoder_rad.col(i).data(),
                            input.group.reference_mm.col(i).data(), 1.0 / input.group.u_mm(i)}),
        nullptr, x.data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options(solver), &problem, &summary);
  return x;
}

// The rows that armcal fills, with its own kernels and sines taken once, for solvers that keep the
// whole Jacobian: r = p + R^T (t - q), turned back into the base frame.
class AllRows {
 public:
  explicit AllRows(const Input& input)
      : input_(input), unknowns_(input.nominal, input.free), postures_(input.group.encoder_rad) {}

  [[nodiscard]] Index rows() const { return 3 * input_.count(); }

  // put(r, row): row r with its derivatives, whitened. No derivatives: row is null.
  template <class Put>
  void fill(const double* x, double* residuals, bool derivatives, const Put& put) const {
    const Eigen::Map<const Numbers> numbers(x);
    const armcal::TipRows tips(unknowns_.arm_at(numbers.head<kArmUnknowns>()), unknowns_.columns());
    const Eigen::Vector3d turn = numbers.segment<3>(kArmUnknowns);
    const Eigen::Matrix3d R = armcal::rotation_from_vector(turn);
    const Eigen::Matrix3d back = R.transpose();
    const Eigen::Matrix3d by_vector = left_jacobian(turn);
    constexpr Index kBlock = 64;
    std::array<double, 3 * kBlock> points;
    std::array<double, 3 * kBlock * kUnknowns> block;
    for (Index first = 0; first < input_.count(); first += kBlock) {
      const Index count = std::min(kBlock, input_.count() - first);
      tips.fill(postures_, first, count,
                {points.data(), derivatives ? block.data() : nullptr, kUnknowns});
      for (Index k = 0; k < count; ++k) {
        const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3d>(points.data() + 3 * k);
        const double weight = 1.0 / input_.group.u_mm(first + k);
        const Index row = 3 * (first + k);
        Eigen::Map<Eigen::Vector3d>(residuals + row) =
            weight * (p + back * (numbers.tail<3>() - input_.group.reference_mm.col(first + k)));
        if (!derivatives) continue;
        Eigen::Map<Eigen::Matrix<double, 3, kUnknowns, Eigen::RowMajor>> J(block.data() +
                                                                           3 * k * kUnknowns);
        J.middleCols<3>(kArmUnknowns) = back * (armcal::skew(-(R * p)) * by_vector);
        J.rightCols<3>() = back;
        J *= weight;
      }
      if (derivatives) put(3 * first, 3 * count, block.data());
    }
  }

 private:
  // d(exp(w)) = (left_jacobian(w) dw) x exp(w)
  static Eigen::Matrix3d left_jacobian(const Eigen::Vector3d& w) {
    const double angle = w.norm();
    const Eigen::Matrix3d W = armcal::skew(w);
    return Eigen::Matrix3d::Identity() + (1.0 - std::cos(angle)) / (angle * angle) * W +
           (angle - std::sin(angle)) / (angle * angle * angle) * W * W;
  }

  const Input& input_;
  armcal::Unknowns unknowns_;
  armcal::PosturePacks postures_;
};

class OneBlock : public ceres::CostFunction {
 public:
  explicit OneBlock(const Input& input) : rows_(input) {
    set_num_residuals(static_cast<int>(rows_.rows()));
    mutable_parameter_block_sizes()->push_back(kUnknowns);
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    double* const J = jacobians == nullptr ? nullptr : jacobians[0];
    rows_.fill(parameters[0], residuals, J != nullptr,
               [&](Index first, Index count, const double* block) {
                 std::copy_n(block, count * kUnknowns, J + first * kUnknowns);
               });
    return true;
  }

 private:
  AllRows rows_;
};

Numbers by_ceres_one_block(const Input& input) {
  Numbers x = input.start();
  ceres::Problem problem;
  problem.AddResidualBlock(new OneBlock(input), nullptr, x.data());
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options(ceres::DENSE_NORMAL_CHOLESKY), &problem, &summary);
  return x;
}

class TinyFunction {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = kUnknowns };
  explicit TinyFunction(const Input& input) : rows_(input) {}
  [[nodiscard]] int NumResiduals() const { return static_cast<int>(rows_.rows()); }
  bool operator()(const double* x, double* residuals, double* jacobian) const {
    using Block = Eigen::Matrix<double, Eigen::Dynamic, kUnknowns, Eigen::RowMajor>;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, kUnknowns>> J(jacobian, rows_.rows(),
                                                                   kUnknowns);
    rows_.fill(x, residuals, jacobian != nullptr,
               [&](Index first, Index count, const double* block) {
                 J.middleRows(first, count) = Eigen::Map<const Block>(block, count, kUnknowns);
               });
    return true;
  }

 private:
  AllRows rows_;
};

Numbers by_tiny_solver(const Input& input) {
  Numbers x = input.start();
  const TinyFunction function(input);
  ceres::TinySolver<TinyFunction> solver;
  solver.options.max_num_iterations = 50;
  solver.options.gradient_tolerance = 0.0;
  solver.options.parameter_tolerance = 0.0;
  // Absolute here; every residual has the size 1 at the optimum.
  solver.options.function_tolerance =
      kRelativeDecrease * static_cast<double>(function.NumResiduals());
  solver.Solve(function, &x);
  return x;
}

// --- the comparison ----------------------------------------------------------------------------

struct Method {
  const char* name;
  std::function<Numbers(const Input&)> run;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"armcal", by_armcal},
      {"Ceres autodiff QR",
       [](const Input& input) { return by_ceres_autodiff(input, ceres::DENSE_QR); }},
      {"Ceres autodiff Cholesky",
       [](const Input& input) { return by_ceres_autodiff(input, ceres::DENSE_NORMAL_CHOLESKY); }},
      {"Ceres one block", by_ceres_one_block},
      {"TinySolver", by_tiny_solver},
  };
  return all;
}

// Largest differences of two optima in mm and rad; the frame's shift at the middle of the points.
struct Difference {
  double mm = 0.0;
  double rad = 0.0;
};
Difference difference(const Input& input, const Numbers& x, const Numbers& y) {
  const armcal::ParameterTable table(input.nominal);
  Difference worst;
  for (Index i = 0; i < kArmUnknowns; ++i) {
    const bool is_length =
        table[input.free[static_cast<std::size_t>(i)]].unit == armcal::ParameterUnit::mm;
    double& place = is_length ? worst.mm : worst.rad;
    place = std::max(place, std::abs(x(i) - y(i)));
  }
  const auto frame = [](const Numbers& z) {
    return RigidTransform{armcal::rotation_from_vector(z.segment<3>(kArmUnknowns)), z.tail<3>()};
  };
  const RigidTransform change = frame(x) * frame(y).inverse();
  const Eigen::Vector3d middle = input.group.reference_mm.rowwise().mean();
  worst.rad = std::max(worst.rad, armcal::vector_from_rotation(change.rotation).norm());
  worst.mm = std::max(worst.mm, (change * middle - middle).norm());
  return worst;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Milliseconds of every method; interleaved, medians. Ends the run where optima differ.
std::vector<double> times_ms(const Input& input, int repetitions) {
  constexpr double kLeast_s = 2e-3;  // of one measurement
  std::vector<std::vector<double>> times(methods().size());
  for (int repetition = 0; repetition <= repetitions; ++repetition) {
    Numbers reference;
    for (std::size_t m = 0; m < methods().size(); ++m) {
      const double begin = cpu_seconds();
      double end = begin;
      int runs = 0;
      Numbers x;
      do {
        x = methods()[m].run(input);
        end = cpu_seconds();
        ++runs;
      } while (end - begin < kLeast_s);
      // The first round warms up, and shows that all mean the same.
      if (repetition > 0) {
        times[m].push_back(1e3 * (end - begin) / runs);
        continue;
      }
      if (m == 0) reference = x;
      const Difference far = difference(input, x, reference);
      if (far.mm < 1e-6 && far.rad < 1e-9) continue;
      std::printf("%s: optimum differs by %.1e mm, %.1e rad\n", methods()[m].name, far.mm, far.rad);
      std::exit(1);
    }
  }
  std::vector<double> medians;
  for (const auto& each : times) medians.push_back(median(each));
  return medians;
}

// A line of /proc/self/status, in MB.
double status_MB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != key + ":") continue;
    double kB = 0.0;
    status >> kB;
    return kB / 1024.0;
  }
  return 0.0;
}

// Peak above what was there, of one run in a process of its own.
double memory_MB(const Method& method, const Input& input) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::exit(1);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts anew
    const double before = status_MB("VmRSS");
    method.run(input);
    const double used = status_MB("VmHWM") - before;
    const bool written = write(ends[1], &used, sizeof used) == sizeof used;
    _exit(written ? 0 : 1);
  }
  double used = 0.0;
  const bool known = read(ends[0], &used, sizeof used) == sizeof used;
  waitpid(child, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  if (!known) std::exit(1);
  return used;
}

// That three digits are seen.
int decimals(double value) { return value < 1.0 ? 3 : value < 10.0 ? 2 : value < 100.0 ? 1 : 0; }

}  // namespace

int main() {
  const std::vector<int> free = free_parameters();
  const auto input_of = [&](int poses) {
    Input input(poses);
    input.free = free;
    return input;
  };
  std::printf("calibration, %d unknowns, one thread, ms\n%8s", kUnknowns, "poses");
  for (const Method& method : methods()) std::printf("%25s", method.name);
  std::printf("\n");
  std::string verdicts;
  std::string memory;
  struct Size {
    int poses;
    int repetitions;
  };
  // The largest first: its memory is measured before anything has been freed.
  for (const Size size : {Size{100000, 3}, Size{10000, 7}, Size{1000, 15}, Size{100, 31}}) {
    const Input input = input_of(size.poses);
    if (size.poses == 100000) {
      for (const Method& method : methods()) {
        char text[100];
        std::snprintf(text, sizeof text, "%s%s %.0f MB", memory.empty() ? "" : ", ", method.name,
                      memory_MB(method, input));
        memory += text;
      }
    }
    const std::vector<double> ms = times_ms(input, size.repetitions);
    std::printf("%8d", size.poses);
    for (const double each : ms) std::printf("%25.3f", each);
    std::printf("\n");
    std::fflush(stdout);
    char text[300];
    std::snprintf(
        text, sizeof text,
        "calibration of %d poses: armcal %.*f ms, Ceres autodiff QR %.*f ms: %.1f times as "
        "fast (wanted: 10), TinySolver %.*f ms: %.1f times (wanted: 1)\n",
        size.poses, decimals(ms[0]), ms[0], decimals(ms[1]), ms[1], ms[1] / ms[0], decimals(ms[4]),
        ms[4], ms[4] / ms[0]);
    verdicts = text + verdicts;
  }
  std::printf("\n%s", verdicts.c_str());
  std::printf("memory above the readings, 100000 poses: %s (wanted of armcal: 30)\n",
              memory.c_str());
}
