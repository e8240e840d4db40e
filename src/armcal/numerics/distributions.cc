// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace armcal {
namespace {

// Without promotion to long double the tails lose three digits; with it the speed is still ample.
using Normal = boost::math::normal_distribution<double>;
using StudentT = boost::math::students_t_distribution<double>;
using ChiSquared = boost::math::chi_squared_distribution<double>;
using FisherF = boost::math::fisher_f_distribution<double>;

}  // namespace

double normal_cdf(double x) { return boost::math::cdf(Normal(), x); }

double normal_quantile(double probability) { return boost::math::quantile(Normal(), probability); }

double student_t_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(StudentT(degrees_of_freedom), probability);
}

double chi_squared_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(ChiSquared(degrees_of_freedom), probability);
}

double chi_squared_survival(double x, double degrees_of_freedom) {
  return boost::math::cdf(boost::math::complement(ChiSquared(degrees_of_freedom), x));
}

double f_quantile(double probability, double numerator, double denominator) {
  return boost::math::quantile(FisherF(numerator, denominator), probability);
}

double f_survival(double x, double numerator, double denominator) {
  return boost::math::cdf(boost::math::complement(FisherF(numerator, denominator), x));
}

}  // namespace armcal
