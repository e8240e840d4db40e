// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// One check of a history.
struct TrendCheck {
  std::string number;  ///< of the check
  std::string time;    ///< ISO 8601
  double days = 0.0;   ///< since the first of them
  double value_mm = 0.0;
  bool breaks_a_rule = false;
};

/// Least-squares line through all checks of a history.
struct TrendDrift {
  double mm_per_day = 0.0;
  double u_mm_per_day = 0.0;
  std::optional<double> now_mm;  ///< at the last check
  std::optional<double> days_to_limit;
  bool is_significant = false;
};

/// A watched value over the checks, from one of the entries of `trends`.
struct TrendHistory {
  std::string name;
  std::string title;  ///< in the language of the reader
  std::optional<double> limit_mm, centre_mm, sigma_mm;
  bool is_signed = false;
  std::string baseline;  ///< how many checks centre and sigma come from
  std::vector<TrendCheck> checks;
  std::optional<TrendDrift> drift;
};

/// @throws InputError where the entry lacks a key or has a time that is none
[[nodiscard]] TrendHistory trend_history(const DocumentView& trend, const Language& say);

/// "largest deviation" in the language of the reader; a name that is not known as it is.
[[nodiscard]] std::string title_of_check_value(const std::string& name, const Language& say);

/// Values over time with centre line, 3 sigma, limit and the line of the drift with the band in
/// which it lies for 95 % of histories. A limit far from all checks is left out and named in the
/// text: it would press them together.
[[nodiscard]] Figure control_chart_figure(const TrendHistory& trend, std::size_t number,
                                          const Language& say);

}  // namespace armcal
