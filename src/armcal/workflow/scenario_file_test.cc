// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "armcal/core/units.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/workflow/scenario_errors.h"
#include "armcal/workflow/simulation_job.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

// Six lines.
constexpr const char* kHead = R"(schema = "armcal.scenario/1"
arm = "nominal.arm.toml"
[[measure]]
with = "reference_cmm"
count = 40

)";

TextFile file(const std::string& text) { return {"lab/a.scenario.toml", text, "UTF-8", ""}; }

SimulationScenario read(const std::string& text) {
  Diagnostics diagnostics;
  const auto scenario = read_scenario_file(file(kHead + text), diagnostics);
  EXPECT_TRUE(scenario.has_value()) << diagnostics.to_text();
  return scenario.value_or(SimulationScenario{});
}

std::string complaint_about_scenario(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_scenario_file(file(kHead + text), diagnostics).has_value());
  return diagnostics.to_text();
}

TEST(ScenarioFile, ReadsWhatItSays) {
  const SimulationScenario scenario = read(R"([surroundings]
column_radius_mm = 60
column_top_mm = -10
bench_mm = -300
[errors]
down = [0, 2, 0]
[errors.geometry]
typical = true
u_length_mm = 0.1
[errors.encoder_noise]
u_arcsec = 2
[[measure]]
with = "multi_sphere_gauge"
name = "long-bar"
form = "points"
[[measure]]
with = "half_turns"
joints = [1, 3]
[check]
points = 10
[estimate]
hold = ["alpha*"]
)");
  EXPECT_EQ(scenario.arm_file, "lab/nominal.arm.toml");
  EXPECT_EQ(scenario.seed, 1u);
  EXPECT_EQ(scenario.surroundings.column_top_mm, -10.0);
  EXPECT_EQ(scenario.surroundings.bench_mm, -300.0);
  EXPECT_EQ(scenario.errors.down, Eigen::Vector3d::UnitY());
  EXPECT_EQ(scenario.errors.geometry.u_length_mm, 0.1);
  EXPECT_EQ(scenario.errors.geometry.u_zero_rad, GeometryErrors::typical().u_zero_rad);
  EXPECT_EQ(scenario.errors.encoder_noise.u_rad, radians_from_arcseconds(2.0));
  EXPECT_FALSE(scenario.errors.gravity_sag.is_on());
  ASSERT_EQ(scenario.measurements.size(), 3u);
  EXPECT_EQ(std::get<ReferenceCmm>(scenario.measurements[0].measurement).count, 40);
  const auto& gauge = std::get<MultiSphereGauge>(scenario.measurements[1].measurement);
  EXPECT_EQ(gauge.name, "long-bar");
  EXPECT_EQ(gauge.form, MultiSphereGauge::Form::points);
  EXPECT_EQ(std::get<HalfTurns>(scenario.measurements[2].measurement).joints,
            (std::vector<int>{1, 3}));
  EXPECT_EQ(scenario.check->points, 10);
  EXPECT_EQ(scenario.estimate.hold, std::vector<std::string>{"alpha*"});
}

TEST(ScenarioFile, TakesAnglesInEitherUnitButNotInBoth) {
  const std::string table = "[errors.geometry]\n";
  EXPECT_EQ(read(table + "u_zero_deg = 0.025\n").errors.geometry.u_zero_rad,
            radians_from_degrees(0.025));
  EXPECT_EQ(read(table + "u_zero_arcsec = 90\n").errors.geometry.u_zero_rad,
            radians_from_arcseconds(90));
  EXPECT_THAT(complaint_about_scenario(table + "u_zero_arcsec = 90\nu_zero_deg = 0.025\n"),
              HasSubstr("u_zero_arcsec and u_zero_deg say the same thing"));
  EXPECT_THAT(complaint_about_scenario(table + "u_zero_rad = 0.1\n"),
              HasSubstr("error: unknown key \"u_zero_rad\"\n  help: did you mean \"u_zero_deg\"?"));
}

TEST(ScenarioFile, SwitchesEverySourceOnInItsTypicalSize) {
  for (const ErrorSourceKeys& source : error_source_keys()) {
    const ErrorSources errors = read("[errors." + source.name + "]\ntypical = true\n").errors;
    int on = 0;
    for (const ErrorSource& each : error_source_list()) {
      if (!each.is_on(errors)) continue;
      ++on;
      EXPECT_EQ(each.name, source.name);
    }
    EXPECT_EQ(on, 1) << source.name;
  }
  EXPECT_EQ(error_source_keys().size(), error_source_list().size());
  EXPECT_TRUE(read("[errors]\ntypical = true\n").errors.bearing_run_out.is_on());
}

TEST(ScenarioFile, TellsAllProblemsAtOnceWithTheirPlaces) {
  const std::string text = complaint_about_scenario(R"(seed = 5
[errors.encoder_noise]
u_arcsec = -2
[errors.grvity_sag]
typical = true
[[measure]]
with = "reference_cm"
[[measure]]
with = "two_seats"
placements = 0
length_mm = "long"
bar = 3
[check]
points = 1
)");
  EXPECT_THAT(text,
              HasSubstr("a.scenario.toml:7:1: error: unknown key \"seed\""));  // of [[measure]]
  EXPECT_THAT(text, HasSubstr("a.scenario.toml:9:1: error: u_arcsec is -2: must not be negative"));
  EXPECT_THAT(text, HasSubstr("error: unknown key \"grvity_sag\"\n  help: did you mean "
                              "\"gravity_sag\"?"));
  EXPECT_THAT(text, HasSubstr("error: nothing measures with \"reference_cm\"\n  help: did you mean "
                              "\"reference_cmm\"?"));
  EXPECT_THAT(text, HasSubstr("error: placements is 0: must be 1 to 100000"));
  EXPECT_THAT(text, HasSubstr("error: length_mm must be a number, not a text"));
  EXPECT_THAT(text, HasSubstr("error: unknown key \"bar\""));
  EXPECT_THAT(text, HasSubstr("error: points is 1: must be 3 to 100000"));
}

TEST(ScenarioFile, RefusesNamesThatAreNoFileNames) {
  const std::string measure = "[[measure]]\nwith = \"cone_seat\"\nname = ";
  for (const char* name : {"../x", "a b", "", ".x", "a;b", "K\\u00e4fig"}) {
    EXPECT_THAT(complaint_about_scenario(measure + "\"" + name + "\"\n"),
                HasSubstr("is no name of a file"))
        << name;
  }
  EXPECT_THAT(complaint_about_scenario(measure + "\"check\"\n"),
              HasSubstr("taken by the check rows"));
  EXPECT_THAT(complaint_about_scenario(measure + "\"cmm\"\n"),
              HasSubstr("two measurements are named \"cmm\""));
}

TEST(ScenarioFile, RefusesWhatDoesNotGoTogether) {
  const std::string platform = "[[measure]]\nwith = \"indexed_platform\"\n";
  EXPECT_THAT(complaint_about_scenario(platform + platform + "name = \"other\"\n"),
              HasSubstr("there is one indexed platform already"));
  EXPECT_THAT(complaint_about_scenario(platform + "[[measure]]\nwith = \"symmetric_point\"\n"),
              HasSubstr("is for an arm without platform"));
  EXPECT_THAT(complaint_about_scenario("[errors]\ndown = [0, 0, 0]\n"),
              HasSubstr("down must be 3 numbers"));
  EXPECT_THAT(complaint_about_scenario("[errors.blunders]\nshare = 2\n"),
              HasSubstr("share is 2: must be 0 to 1"));
}

TEST(ScenarioFile, RefusesADrawnAndAGivenTruthTogether) {
  Diagnostics diagnostics;
  const std::string text =
      "schema = \"armcal.scenario/1\"\narm = \"a\"\ntruth = \"b\"\n[errors.geometry]\ntypical = "
      "true\n";
  EXPECT_FALSE(read_scenario_file(file(text), diagnostics).has_value());
  EXPECT_THAT(diagnostics.to_text(),
              HasSubstr(":3:1: error: the geometry is given by truth and by [errors.geometry]"));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("error: measures nothing"));
}

TEST(ScenarioFile, IsDocumentedKeyByKey) {
  const std::string page = testing::read_bytes(testing::repository() / "docs/files/scenario.md");
  const auto expect_named = [&](const std::string& word) {
    EXPECT_THAT(page, HasSubstr("`" + word + "`"));
  };
  for (const ErrorSourceKeys& source : error_source_keys()) {
    expect_named(source.name);
    for (const std::string& key : source.keys) expect_named(key);
  }
  for (const MeasurementKind& kind : measurement_kinds()) {
    expect_named(kind.name);
    for (const std::string& key : kind.keys) expect_named(key);
  }
}

TEST(ScenarioFile, IsBuiltInForEveryExample) {
  std::vector<std::string> names;
  for (const BuiltInScenario& each : built_in_scenarios()) {
    EXPECT_FALSE(each.brief.empty()) << each.name;
    names.push_back(each.name);
  }
  for (const auto& entry :
       std::filesystem::directory_iterator(testing::repository() / "examples/scenarios")) {
    const std::string name = entry.path().filename().string();
    EXPECT_THAT(names, ::testing::Contains(name.substr(0, name.find('.'))));
  }
}

RC_GTEST_PROP(ScenarioFile, SurvivesAnyBytes, (const std::string& text)) {
  Diagnostics diagnostics;
  const bool read = read_scenario_file(file(kHead + text), diagnostics).has_value();
  RC_ASSERT(read != diagnostics.has_errors());
}

}  // namespace
}  // namespace armcal
