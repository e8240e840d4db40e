// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// How fast files become readings: bytes of text in, checked radians and millimetres out.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "armcal/core/random.h"
#include "armcal/io/reading_tables.h"
#include "armcal/io/text_encoding.h"

namespace {

constexpr int kRows = 200000;

std::string angles(char separator, bool decimal_comma) {
  armcal::RandomStream random(1);
  std::string text =
      fmt::format("q1_deg{0}q2_deg{0}q3_deg{0}q4_deg{0}q5_deg{0}q6_deg\n", separator);
  for (int row = 0; row < kRows; ++row) {
    for (int joint = 0; joint < 6; ++joint) {
      std::string number = fmt::format("{:.6f}", random.uniform(-180.0, 180.0));
      if (decimal_comma) number[number.find('.')] = ',';
      text += number;
      text += joint < 5 ? separator : '\n';
    }
  }
  return text;
}

std::string points() {
  armcal::RandomStream random(2);
  std::string text = "x_mm,y_mm,z_mm\n";
  for (int row = 0; row < kRows; ++row) {
    text += fmt::format("{:.5f},{:.5f},{:.5f}\n", random.uniform(-1e3, 1e3),
                        random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3));
  }
  return text;
}

armcal::CsvTable table_of(const std::string& text, armcal::Diagnostics& diagnostics) {
  armcal::DecodedText decoded = armcal::decode_text(text);
  if (armcal::first_binary_byte(decoded.text)) std::abort();
  auto table = armcal::CsvTable::parse({"memory", std::move(decoded.text), decoded.encoding, ""},
                                       {}, diagnostics);
  if (!table) std::abort();
  return std::move(*table);
}

void joint_angles(benchmark::State& state, const std::string& text) {
  for (auto _ : state) {
    armcal::Diagnostics diagnostics;
    const auto table = table_of(text, diagnostics);
    const auto readings = armcal::joint_readings(table, 6, {}, diagnostics);
    if (!readings || readings->count() != kRows) std::abort();
    benchmark::DoNotOptimize(readings->encoder_rad.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size()));
}

void coordinates(benchmark::State& state, const std::string& text) {
  for (auto _ : state) {
    armcal::Diagnostics diagnostics;
    const auto table = table_of(text, diagnostics);
    const auto readings = armcal::point_readings(table, {}, diagnostics);
    if (!readings || readings->points_mm.size() != kRows) std::abort();
    benchmark::DoNotOptimize(readings->points_mm.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size()));
}

BENCHMARK_CAPTURE(joint_angles, comma, angles(',', false))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(joint_angles, semicolon_and_decimal_comma, angles(';', true))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(coordinates, comma, points())->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
