// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "armcal/testing/reference_data.h"

namespace armcal {
namespace {

// Rows of numbers of one of the tables of exact quantiles; header skipped.
std::vector<std::vector<double>> table(const std::string& name) {
  std::ifstream file(testing::reference_data() / "oracles/statistics" / name);
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<double> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    rows.push_back(row);
  }
  return rows;
}

// Published figures: half of the last digit they print, and a little for the rounding of that.
double half_of_last_digit(const std::string& printed) {
  const auto point = printed.find('.');
  const auto decimals = point == printed.npos ? 0 : printed.size() - point - 1;
  return 0.5000001 * std::pow(10.0, -static_cast<double>(decimals));
}

// The fields of each line of a table of published quantiles; header skipped.
std::vector<std::vector<std::string>> printed_table(const std::string& name) {
  std::ifstream file(testing::reference_data() / "oracles/statistics" / name);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<std::string> row(4);
    for (std::string& field : row) std::getline(fields, field, ',');
    rows.push_back(row);
  }
  return rows;
}

// 68.27, 95.45 and 99.73 % stand for one, two and three standard deviations.
double level_of(const std::string& percent) {
  const double printed = std::stod(percent);
  for (const double sigmas : {1.0, 2.0, 3.0}) {
    const double exact = std::erf(sigmas / std::sqrt(2.0));
    if (std::abs(100.0 * exact - printed) < 0.005) return exact;
  }
  return printed / 100.0;
}

// The quantile at a probability typed with few digits near 0 or 1 amplifies the rounding of that
// probability; all entries of the tables are far enough from that.
constexpr double kRelative = 1e-12;

TEST(Distributions, QuantilesAgreeWithTheExactTables) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  for (const auto& row : table("normal_quantiles_exact.csv")) {
    EXPECT_NEAR(normal_quantile(row[0]), row[1], kRelative * std::abs(row[1])) << row[0];
  }
  for (const auto& row : table("student_t_quantiles_exact.csv")) {
    EXPECT_NEAR(student_t_quantile(row[1], row[0]), row[2], kRelative * std::abs(row[2]))
        << "nu " << row[0] << " p " << row[1];
  }
  for (const auto& row : table("chi2_quantiles_exact.csv")) {
    EXPECT_NEAR(chi_squared_quantile(row[1], row[0]), row[2], kRelative * std::abs(row[2]))
        << "nu " << row[0] << " p " << row[1];
  }
  for (const auto& row : table("f_quantiles_exact.csv")) {
    EXPECT_NEAR(f_quantile(row[2], row[0], row[1]), row[3], kRelative * std::abs(row[3]))
        << row[0] << " " << row[1] << " p " << row[2];
  }
}

TEST(Distributions, QuantilesAgreeWithThePublishedTables) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  const auto student = printed_table("student_t_gum_g2.csv");
  ASSERT_EQ(student.size(), 168u);
  for (const auto& row : student) {
    const double t = student_t_quantile(0.5 * (1.0 + level_of(row[1])), std::stod(row[0]));
    EXPECT_NEAR(t, std::stod(row[3]), 1e-10 * t) << row[0] << " " << row[1];
    if (row[0] == "35" && row[1] == "90") continue;  // printed 1.70; it is 1.68957
    EXPECT_NEAR(t, std::stod(row[2]), half_of_last_digit(row[2])) << row[0] << " " << row[1];
  }
  const auto chi2 = printed_table("chi2_nist_handbook.csv");
  ASSERT_EQ(chi2.size(), 45u);
  for (const auto& row : chi2) {
    const double x = chi_squared_quantile(std::stod(row[1]), std::stod(row[0]));
    EXPECT_NEAR(x, std::stod(row[3]), 1e-10 * x) << row[0] << " " << row[1];
    EXPECT_NEAR(x, std::stod(row[2]), half_of_last_digit(row[2])) << row[0] << " " << row[1];
  }
}

TEST(Distributions, FunctionsInvertTheirQuantiles) {
  EXPECT_NEAR(normal_cdf(normal_quantile(0.975)), 0.975, 1e-15);
  EXPECT_NEAR(chi_squared_survival(chi_squared_quantile(0.95, 3.7), 3.7), 0.05, 1e-14);
  EXPECT_NEAR(f_survival(f_quantile(0.95, 2.0, 9.0), 2.0, 9.0), 0.05, 1e-14);
  // GUM Table G.2: t for 10 degrees of freedom and 95 %.
  EXPECT_NEAR(student_t_quantile(0.975, 10.0), 2.23, 0.005);
}

TEST(Distributions, RefuseWhatIsNoProbability) {
  EXPECT_THROW(static_cast<void>(normal_quantile(1.5)), std::domain_error);
  EXPECT_THROW(static_cast<void>(student_t_quantile(0.9, 0.0)), std::domain_error);
}

}  // namespace
}  // namespace armcal
