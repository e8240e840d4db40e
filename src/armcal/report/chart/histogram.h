// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armcal/report/chart/chart.h"

namespace armcal {

struct HistogramBins {
  std::vector<double> edges;  ///< one more than counts, equally wide, on multiples of 1, 2 or 5
                              ///< times a power of ten
  std::vector<double> counts;
  std::size_t beyond = 0;  ///< values outside of the edges, counted in the first or last bin
};

/// Bins about 2 IQR / n^(1/3) wide (Freedman and Diaconis 1981), rounded up to a nice width; 1 to
/// 60 of them. Values that are not finite are left out; none left: no bins. What lies more than
/// five times the range of the middle half away from it is counted in the first or last bin.
[[nodiscard]] HistogramBins histogram_bins(std::span<const double> values);

/// Adds to a chart that has its words the bins of standardised residuals (divided by the
/// uncertainty stated for them) and, as steps, how many a normal distribution of standard deviation
/// 1 would put into each.
[[nodiscard]] Chart with_histogram(Chart chart, const std::string& name,
                                   const std::string& density_name, const HistogramBins& bins);

struct QuantilePlotNames {
  std::string points;
  std::string diagonal;  ///< what a normal distribution as stated gives
  std::string band;      ///< where 95 % of each of its order statistics lie
};
/// Adds the normal quantile plot: each sorted value over the quantile of (i - 3/8) / (n + 1/4)
/// (Blom 1958), the diagonal, and the pointwise 95 % band of the order statistics, which are those
/// of a beta distribution (i, n + 1 - i) put through the normal quantile. Values beyond the edges
/// of histogram_bins(values) keep their places in the order but are not drawn: one far off would
/// press all others to the ground.
[[nodiscard]] Chart with_normal_quantiles(Chart chart, const QuantilePlotNames& names,
                                          std::span<const double> values);

}  // namespace armcal
