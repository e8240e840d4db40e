// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/live_chart.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "armcal/report/chart/svg.h"

namespace armcal {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson short_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

OrderedJson numbers(const std::vector<double>& values) {
  OrderedJson list = OrderedJson::array();
  for (const double value : values) list.push_back(short_number(value));
  return list;
}

OrderedJson live_json(const ChartAxis& axis) {
  const auto end = [](const std::optional<double>& value) {
    return value ? short_number(*value) : OrderedJson(nullptr);
  };
  return {{"label", axis.label},
          {"scale", axis.scale == AxisScale::linear ? "linear" : "log"},
          {"low", end(axis.low)},
          {"high", end(axis.high)}};
}

const char* name_of(Mark mark) {
  switch (mark) {
    case Mark::line:
      return "line";
    case Mark::steps:
      return "steps";
    case Mark::bars:
      return "bars";
    case Mark::dots:
      break;
  }
  return "dots";
}

OrderedJson live_json(const ChartSeries& series) {
  OrderedJson json = {{"name", series.name},
                      {"mark", name_of(series.mark)},
                      {"style", series.style},
                      {"x", numbers(series.x)},
                      {"y", numbers(series.y)}};
  if (!series.labels.empty()) json["labels"] = series.labels;
  if (!series.tags.empty()) json["tags"] = series.tags;
  return json;
}

}  // namespace

std::string live_chart(const Chart& chart) {
  OrderedJson series = OrderedJson::array();
  for (const ChartSeries& each : chart.series) series.push_back(live_json(each));
  OrderedJson lines = OrderedJson::array();
  for (const ChartLine& line : chart.lines) {
    if (!std::isfinite(line.at)) continue;
    lines.push_back({{"vertical", line.is_vertical},
                     {"at", short_number(line.at)},
                     {"label", line.label},
                     {"tone", tone_class(line.tone)}});
  }
  const OrderedJson json = {{"kind", "chart"},
                            {"x", live_json(chart.x)},
                            {"y", live_json(chart.y)},
                            {"equal", chart.equal_scales},
                            {"series", std::move(series)},
                            {"lines", std::move(lines)}};
  // Names come from files: bytes that are not UTF-8 must not end the report.
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace armcal
