// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "armcal/numerics/least_squares.h"
#include "armcal/testing/reference_data.h"

// The 27 nonlinear regressions of NIST's Statistical Reference Datasets: 11 certified digits, each
// from a far start (1) and a near one (2).

namespace armcal {
namespace {

constexpr std::size_t kMostUnknowns = 9;

// A number with its derivatives by the parameters.
struct Dual {
  double value = 0.0;
  std::array<double, kMostUnknowns> slopes{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants mix with duals in the formulas below

  [[nodiscard]] Dual mapped(double v, double slope) const {
    Dual result(v);
    for (std::size_t i = 0; i < kMostUnknowns; ++i) result.slopes[i] = slope * slopes[i];
    return result;
  }
  friend Dual operator-(const Dual& a) { return a.mapped(-a.value, -1.0); }
  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual result(a.value + b.value);
    for (std::size_t i = 0; i < kMostUnknowns; ++i) result.slopes[i] = a.slopes[i] + b.slopes[i];
    return result;
  }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + (-b); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual result = a.mapped(a.value * b.value, b.value) + b.mapped(0.0, a.value);
    return result;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return a.mapped(quotient, 1.0 / b.value) + b.mapped(0.0, -quotient / b.value);
  }
};
Dual exp(const Dual& a) { return a.mapped(std::exp(a.value), std::exp(a.value)); }
Dual log(const Dual& a) { return a.mapped(std::log(a.value), 1.0 / a.value); }
Dual sqrt(const Dual& a) { return a.mapped(std::sqrt(a.value), 0.5 / std::sqrt(a.value)); }
Dual cos(const Dual& a) { return a.mapped(std::cos(a.value), -std::sin(a.value)); }
Dual sin(const Dual& a) { return a.mapped(std::sin(a.value), std::cos(a.value)); }
Dual atan(const Dual& a) { return a.mapped(std::atan(a.value), 1.0 / (1.0 + a.value * a.value)); }
Dual pow(const Dual& a, const Dual& b) { return exp(b * log(a)); }
Dual square(const Dual& a) { return a * a; }

using Row = std::vector<double>;  // y, then the predictors
using Model = std::function<Dual(const std::vector<Dual>& b, const Row& row)>;

Dual polynomial(const std::vector<Dual>& b, std::size_t first, std::size_t count, double x) {
  Dual sum = 0.0;
  for (std::size_t i = first + count; i-- > first;) sum = sum * x + b[i];
  return sum;
}

Model gauss() {
  return [](const auto& b, const Row& r) {
    return b[0] * exp(-b[1] * r[1]) + b[2] * exp(-square((r[1] - b[3]) / b[4])) +
           b[5] * exp(-square((r[1] - b[6]) / b[7]));
  };
}
Model lanczos() {
  return [](const auto& b, const Row& r) {
    return b[0] * exp(-b[1] * r[1]) + b[2] * exp(-b[3] * r[1]) + b[4] * exp(-b[5] * r[1]);
  };
}
Model chwirut() {
  return [](const auto& b, const Row& r) { return exp(-b[0] * r[1]) / (b[1] + b[2] * r[1]); };
}
Model saturation() {
  return [](const auto& b, const Row& r) { return b[0] * (1.0 - exp(-b[1] * r[1])); };
}
Model cubic_over_cubic() {
  return [](const auto& b, const Row& r) {
    return polynomial(b, 0, 4, r[1]) / (1.0 + r[1] * polynomial(b, 4, 3, r[1]));
  };
}
Dual wave(const std::vector<Dual>& b, std::size_t period, double x) {
  const Dual angle = 2.0 * std::numbers::pi * x / b[period];
  return b[period + 1] * cos(angle) + b[period + 2] * sin(angle);
}

// The models as NIST prints them.
const std::map<std::string, Model>& models() {
  static const std::map<std::string, Model> all = {
      {"Bennett5",
       [](const auto& b, const Row& r) { return b[0] * pow(b[1] + r[1], -1.0 / b[2]); }},
      {"BoxBOD", saturation()},
      {"Chwirut1", chwirut()},
      {"Chwirut2", chwirut()},
      {"DanWood", [](const auto& b, const Row& r) { return b[0] * pow(r[1], b[1]); }},
      {"ENSO",
       [](const auto& b, const Row& r) {
         const double year = std::numbers::pi * r[1] / 6.0;
         return b[0] + b[1] * std::cos(year) + b[2] * std::sin(year) + wave(b, 3, r[1]) +
                wave(b, 6, r[1]);
       }},
      {"Eckerle4",
       [](const auto& b, const Row& r) {
         return b[0] / b[1] * exp(-0.5 * square((r[1] - b[2]) / b[1]));
       }},
      {"Gauss1", gauss()},
      {"Gauss2", gauss()},
      {"Gauss3", gauss()},
      {"Hahn1", cubic_over_cubic()},
      {"Kirby2",
       [](const auto& b, const Row& r) {
         return polynomial(b, 0, 3, r[1]) / (1.0 + r[1] * polynomial(b, 3, 2, r[1]));
       }},
      {"Lanczos1", lanczos()},
      {"Lanczos2", lanczos()},
      {"Lanczos3", lanczos()},
      {"MGH09",
       [](const auto& b, const Row& r) {
         return b[0] * r[1] * (r[1] + b[1]) / (r[1] * (r[1] + b[2]) + b[3]);
       }},
      {"MGH10", [](const auto& b, const Row& r) { return b[0] * exp(b[1] / (r[1] + b[2])); }},
      {"MGH17",
       [](const auto& b, const Row& r) {
         return b[0] + b[1] * exp(-b[3] * r[1]) + b[2] * exp(-b[4] * r[1]);
       }},
      {"Misra1a", saturation()},
      {"Misra1b",
       [](const auto& b, const Row& r) {
         return b[0] * (1.0 - 1.0 / square(1.0 + 0.5 * b[1] * r[1]));
       }},
      {"Misra1c", [](const auto& b,
                     const Row& r) { return b[0] * (1.0 - 1.0 / sqrt(1.0 + 2.0 * b[1] * r[1])); }},
      {"Misra1d",
       [](const auto& b, const Row& r) { return b[0] * b[1] * r[1] / (1.0 + b[1] * r[1]); }},
      {"Nelson",
       [](const auto& b, const Row& r) { return b[0] - b[1] * r[1] * exp(-b[2] * r[2]); }},
      {"Rat42", [](const auto& b, const Row& r) { return b[0] / (1.0 + exp(b[1] - b[2] * r[1])); }},
      {"Rat43", [](const auto& b,
                   const Row& r) { return b[0] / pow(1.0 + exp(b[1] - b[2] * r[1]), 1.0 / b[3]); }},
      {"Roszman1",
       [](const auto& b, const Row& r) {
         return b[0] - b[1] * r[1] - atan(b[2] / (r[1] - b[3])) / std::numbers::pi;
       }},
      {"Thurber", cubic_over_cubic()},
  };
  return all;
}

struct Dataset {
  std::string name;
  std::vector<Row> rows;
  std::array<Eigen::VectorXd, 2> starts;
  Eigen::VectorXd parameters;
  Eigen::VectorXd deviations;
};

Eigen::VectorXd numbers(const nlohmann::json& list) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values(i) = std::stod(list[static_cast<std::size_t>(i)].get<std::string>());
  }
  return values;
}

std::vector<Row> read_rows(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

std::vector<Dataset> datasets() {
  const auto folder = testing::reference_data() / "oracles" / "nist_strd_nls";
  std::ifstream file(folder / "expected.json");
  std::vector<Dataset> all;
  for (const auto& entry : nlohmann::json::parse(file)) {
    Dataset set;
    set.name = entry.at("name");
    set.rows = read_rows(folder / entry.at("data").get<std::string>());
    set.starts = {numbers(entry.at("start1")), numbers(entry.at("start2"))};
    // Certified to 11 digits; refined further where the certified residuals are rounding
    // themselves.
    set.parameters = numbers(entry.at("refined_values_30d"));
    set.deviations = numbers(entry.at("refined_std_20d"));
    all.push_back(std::move(set));
  }
  return all;
}

class Regression : public LeastSquaresProblem {
 public:
  explicit Regression(const Dataset& set)
      : set_(set), columns_(static_cast<std::size_t>(set.parameters.size())) {
    std::iota(columns_.begin(), columns_.end(), 0);
  }
  [[nodiscard]] int unknown_count() const override { return static_cast<int>(columns_.size()); }
  [[nodiscard]] int block_count() const override { return 1; }
  [[nodiscard]] BlockShape shape(int) const override {
    return {static_cast<Eigen::Index>(set_.rows.size()), 1, columns_};
  }
  [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const override {
    struct Here : Evaluation {
      const Dataset& set;
      std::vector<Dual> b;
      explicit Here(const Dataset& s) : set(s) {}
      void fill(int, const BlockRows& rows) const override {
        const Model& model = models().at(set.name);
        for (Eigen::Index r = 0; r < rows.rows; ++r) {
          const Row& datum = set.rows[static_cast<std::size_t>(r)];
          const Dual value = model(b, datum);
          std::copy_n(value.slopes.begin(), b.size(), rows.row(r));
          rows.residual(r) = value.value - (set.name == "Nelson" ? std::log(datum[0]) : datum[0]);
        }
      }
    };
    auto here = std::make_unique<Here>(set_);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      here->b.emplace_back(x(static_cast<Eigen::Index>(i)));
      here->b.back().slopes[i] = 1.0;
    }
    return here;
  }
  // Rounding of the largest datum.
  [[nodiscard]] double resolution() const {
    double largest = 0.0;
    for (const Row& row : set_.rows) largest = std::max(largest, std::abs(row[0]));
    return 1e-16 * largest;
  }

 private:
  const Dataset& set_;
  std::vector<int> columns_;
};

// Number of correct digits of the worst element.
double correct_digits(const Eigen::VectorXd& values, const Eigen::VectorXd& expected) {
  const double error = ((values - expected).array() / expected.array()).abs().maxCoeff();
  return error == 0.0 ? 16.0 : -std::log10(error);
}

struct Digits {
  double parameters = 0.0;
  double deviations = 0.0;
};

Digits digits(const Dataset& set, const LeastSquaresSolution& solution) {
  const auto freedom = static_cast<double>(solution.rows - set.parameters.size());
  const Eigen::VectorXd deviations =
      solution.inverse_factor.rowwise().norm() * std::sqrt(solution.cost / freedom);
  return {correct_digits(solution.x, set.parameters), correct_digits(deviations, set.deviations)};
}

LeastSquaresSolution solved(const Dataset& set, std::size_t start) {
  const Regression problem(set);
  return solve_least_squares(problem, set.starts[start],
                             {.max_iterations = 1000, .residual_resolution = problem.resolution()});
}

// Lanczos1 is exact to the digits of its data: what its residuals scatter is rounding.
bool scatters(const Dataset& set) { return set.name != "Lanczos1"; }

std::string told(const LeastSquaresSolution& solution) {
  std::ostringstream text;
  text << to_string(solution.termination) << " after " << solution.iterations
       << " steps, condition number " << solution.condition_number;
  return text.str();
}

void expect_certified_digits(const Dataset& set, const LeastSquaresSolution& solution) {
  const Digits correct = digits(set, solution);
  EXPECT_GE(correct.parameters, 6.0) << told(solution);
  if (scatters(set)) {
    EXPECT_GE(correct.deviations, 4.0) << told(solution);
  }
}

TEST(NistStrd, AllSetsReachTheCertifiedDigitsFromTheNearStart) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  const auto sets = datasets();
  ASSERT_EQ(sets.size(), 27U);
  for (const Dataset& set : sets) {
    SCOPED_TRACE(set.name);
    const LeastSquaresSolution solution = solved(set, 1);
    ASSERT_TRUE(solution.ok()) << told(solution);
    expect_certified_digits(set, solution);
  }
}

TEST(NistStrd, NoSetClaimsFalselyToHaveConvergedFromTheFarStart) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  int failures = 0;
  for (const Dataset& set : datasets()) {
    SCOPED_TRACE(set.name);
    const LeastSquaresSolution solution = solved(set, 0);
    if (!solution.ok()) {
      ++failures;
      std::cout << set.name << " from its far start: " << told(solution) << '\n';
      continue;
    }
    expect_certified_digits(set, solution);
  }
  // All succeed where this was written; another mathematical library may lead past a ridge.
  EXPECT_LE(failures, 2);
}

TEST(NistStrd, TenIterationsFailHonestlyOrSucceed) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  for (const Dataset& set : datasets()) {
    SCOPED_TRACE(set.name);
    const LeastSquaresSolution solution =
        solve_least_squares(Regression(set), set.starts[0], {.max_iterations = 10});
    if (solution.ok()) expect_certified_digits(set, solution);
  }
}

}  // namespace
}  // namespace armcal
