// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/paper_demo.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/report/number_format.h"
#include "armcal/report/symmetric_point_report.h"
#include "armcal/report/text_table.h"
#include "armcal/symmetric_point/wang2016.h"
#include "armcal/workflow/input_files.h"
#include "armcal/workflow/symmetric_point_job.h"

namespace armcal {
namespace {

// Section 3.2 of the paper: a sphere of certified diameter, measured with the calibrated arm.
constexpr double kCertifiedDiameter_mm = 15.8754;
constexpr double kMeasuredDiameter_mm = 15.8145;

struct Member {
  const char* name;
  double Wang2016Parameters::*value;
};
constexpr std::array<Member, 6> kTable2 = {{{"a5", &Wang2016Parameters::a5},
                                            {"a7", &Wang2016Parameters::a7},
                                            {"b3", &Wang2016Parameters::b3},
                                            {"b5", &Wang2016Parameters::b5},
                                            {"b7", &Wang2016Parameters::b7},
                                            {"d7", &Wang2016Parameters::d7}}};

double reading(const SymmetricPointAnalysis& analysis, std::string_view name) {
  for (const SymmetricReading& one : analysis.readings) {
    if (one.name == name) return one.value;
  }
  return std::nan("");
}

Wang2016Readings table1(const SymmetricPointAnalysis& analysis) {
  return {reading(analysis, "l_PP1"), reading(analysis, "l_PP2"), reading(analysis, "l_PP3"),
          reading(analysis, "l_PP4"), reading(analysis, "l_PP5"), reading(analysis, "R")};
}

double claimed(const SymmetricPointAnalysis& analysis, std::string_view name) {
  for (const ClaimCheck& claim : analysis.claims) {
    if (claim.name == name) return claim.claimed;
  }
  return std::nan("");
}

std::string equations_text(const Wang2016Readings& r) {
  const Wang2016Parameters p = consistent_chain(r);
  const auto line = [](const char* equation, double value, const char* note) {
    return fmt::format("  {:<28} = {:>8} mm{}\n", equation, fixed(value, 3), note);
  };
  return line("b7 = l_PP1 / 2", p.b7, "   (the tip arm; the paper calls it d7)") +
         line("a7 = l_PP2 / 2", p.a7, "") + line("a5 = l_PP3 / 2 + a7", p.a5, "") +
         line("b5 = l_PP4 / 2 - a7", p.b5, "") + line("b3 = l_PP5 / 2 + b7 - a5", p.b3, "") +
         line("R  = hypot(a7, b7)", std::hypot(p.a7, p.b7),
              fmt::format("   (read: {}: a check)", fixed(r.R, 3)).c_str());
}

std::string table2_text(const SymmetricPointAnalysis& printed,
                        const SymmetricPointAnalysis& meant) {
  const Wang2016Parameters literal = literal_chain(table1(printed));
  const Wang2016Parameters consistent = consistent_chain(table1(meant));
  const ParameterTable parameters(meant.adjustment.arm);
  TextTable table({{"", Align::left},
                   {"Table 2"},
                   {"literal chain"},
                   {"consistent chain"},
                   {"adjustment"},
                   {"u"}});
  for (const Member& member : kTable2) {
    const int index = parameters.find(member.name).value();
    std::string u = "held";
    for (std::size_t i = 0; i < meant.adjustment.unknowns.size(); ++i) {
      if (meant.adjustment.unknowns[i] == index) {
        u = fixed(meant.adjustment.u(static_cast<Eigen::Index>(i)), 4);
      }
    }
    table.add_row({member.name, fixed(claimed(printed, member.name), 3),
                   fixed(literal.*member.value, 3), fixed(consistent.*member.value, 3),
                   fixed(parameters[index].nominal, 3), u});
  }
  return table.text();
}

// How far each arm is from the six readings.
std::string prediction_text(const SymmetricPointAnalysis& analysis) {
  const ParameterTable table(analysis.adjustment.arm);
  TextTable rows({{"reading", Align::left}, {"read"}, {"consistent set"}, {"set as printed"}});
  for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    rows.add_row({analysis.readings[i].name, fixed(analysis.readings[i].value, 3),
                  fixed(analysis.adjustment.readings[i].predicted, 3),
                  fixed(analysis.predicted_by_compared(place), 3)});
  }
  return rows.text();
}

std::string numbered(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += "  - " + sentence + "\n";
  return text;
}

// Those findings that a section is about.
std::vector<std::string> findings_with(const SymmetricPointAnalysis& analysis,
                                       std::string_view word) {
  std::vector<std::string> chosen;
  for (const std::string& sentence : findings(analysis)) {
    if (sentence.find(word) != std::string::npos) chosen.push_back(sentence);
  }
  return chosen;
}

}  // namespace

PaperDemo run_paper_demo() {
  InputFiles files({}, FileSource::embedded);
  const auto run = [&](const char* name, const std::optional<std::string>& compared) {
    return run_symmetric_point(files, fmt::format("examples/wang2016/{}.symmetric.toml", name),
                               compared, {});
  };
  const auto printed = run("as-printed", std::nullopt);
  const auto meant = run("as-meant", "examples/arms/romer-infinite-2.0-as-printed.arm.toml");
  const auto signs = run("signs", std::nullopt);
  const double sphere_error_mm = kMeasuredDiameter_mm - kCertifiedDiameter_mm;
  const double relative_error = sphere_error_mm / kCertifiedDiameter_mm;

  PaperDemo demo;
  demo.inputs = files.records();
  demo.text = fmt::format(
      "The symmetric-point calibration of a ROMER Infinite 2.0, recomputed from its printed "
      "readings\n"
      "Wang, Wang, Lu, Zhang, Trans. Chinese Soc. Agric. Machinery 47(6), 2016, 408-412\n"
      "\nTable 1: distances between symmetric points, mm\n{}"
      "\nThe equations that these numbers obey (printed ones are lost; l_PP3 as printed)\n{}"
      "\nTable 2 beside the program, mm (l_PP3 = {} in the last three columns)\n{}"
      "\nFinding 1: one reading is misprinted, and the readings alone cannot show it\n{}{}"
      "\nFinding 2: the tip is counted twice\n{}{}"
      "\nFinding 3: a reversal has no sign\n{}"
      "\nLeakage of the chain: what the method assumes comes back as error of its result\n{}"
      "\nThe paper's check: a sphere of {} mm measured as {} mm: error {} mm, relative error {} "
      "%.\n"
      "A diameter alone verifies little: see armcal verify sphere, which also judges form and "
      "articulation.\n",
      readings_text(printed), equations_text(table1(printed)), fixed(reading(meant, "l_PP3"), 3),
      table2_text(printed, meant), numbered(findings_with(printed, "agrees with")),
      numbered(findings_with(printed, "checked by nothing")),
      numbered(findings_with(printed, "same length")), prediction_text(meant),
      numbered(findings_with(signs, "combinations of signs")), leakage_text(meant, 10),
      fixed(kCertifiedDiameter_mm, 4), fixed(kMeasuredDiameter_mm, 4), fixed(sphere_error_mm, 4),
      fixed(std::abs(100.0 * relative_error), 4));

  const Wang2016Parameters literal = literal_chain(table1(printed));
  const Wang2016Parameters consistent = consistent_chain(table1(meant));
  for (const Member& member : kTable2) {
    demo.json["table2"][member.name] = json_number(claimed(printed, member.name));
    demo.json["literal_chain"][member.name] = literal.*member.value;
    demo.json["consistent_chain"][member.name] = consistent.*member.value;
  }
  demo.json["as_printed"] = json_result(printed);
  demo.json["as_meant"] = json_result(meant);
  demo.json["signs"] = json_result(signs)["signs"];
  demo.json["findings"] = {
      fmt::format("One reading is misprinted, and the readings alone cannot show it. {} {}",
                  fmt::join(findings_with(printed, "agrees with"), " "),
                  fmt::join(findings_with(printed, "checked by nothing"), " ")),
      fmt::format("The tip is counted twice. {}",
                  fmt::join(findings_with(printed, "same length"), " ")),
      fmt::format("A reversal has no sign. {}",
                  fmt::join(findings_with(signs, "combinations of signs"), " "))};
  demo.json["sphere"] = {{"certified_diameter_mm", kCertifiedDiameter_mm},
                         {"measured_diameter_mm", kMeasuredDiameter_mm},
                         {"error_mm", sphere_error_mm},
                         {"relative_error", relative_error}};
  return demo;
}

}  // namespace armcal
