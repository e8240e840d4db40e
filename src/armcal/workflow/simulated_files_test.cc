// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// What is simulated without noise, written, read and calibrated is the truth.
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/io/arm_file.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/wang2016_arm.h"
#include "armcal/workflow/calibration_job.h"
#include "armcal/workflow/simulation_job.h"
#include "armcal/workflow/symmetric_point_job.h"
#include "armcal/workflow/truth_check.h"

namespace armcal {
namespace {

struct Kit {
  const char* name;
  const char* measurements;
};

constexpr Kit kKits[] = {
    {"ReferenceCmm", "[[measure]]\nwith = \"reference_cmm\"\nu_mm = 0\n"},
    {"LaserTracker",
     "[[measure]]\nwith = \"laser_tracker\"\nu_distance_mm = 0\nu_angle_arcsec = 0\n"},
    {"PoseTracker",
     "[[measure]]\nwith = \"pose_tracker\"\ncount = 30\nu_mm = 0\nu_turn_arcsec = 0\n"},
    {"ConesAndBar",
     "[[measure]]\nwith = \"cone_seat\"\nseats = 2\npostures = 20\nu_mm = 0\n[[measure]]\nwith = "
     "\"two_seats\"\npostures = 20\nu_mm = 0\nu_length_mm = 0\n"},
    {"BallBar", "[[measure]]\nwith = \"ball_bar\"\nplacements = 8\nu_mm = 0\n"},
    {"Gauge", "[[measure]]\nwith = \"multi_sphere_gauge\"\nspheres = 7\nu_mm = 0\n"},
    {"GaugeAsPoints",
     "[[measure]]\nwith = \"multi_sphere_gauge\"\nform = \"points\"\nspheres = 5\npitch_mm = "
     "200\npostures = 6\nplacements = 2\nu_mm = 0\nu_length_mm = 0\n"},
    {"SpherePlate", "[[measure]]\nwith = \"sphere_plate\"\nrows = 2\nu_mm = 0\n"},
    {"StraightLine", "[[measure]]\nwith = \"straight_line\"\npositions = 3\nu_mm = 0\n"},
    {"Sphere",
     "[[measure]]\nwith = \"calibrated_sphere\"\nplacements = 4\npoints = 20\nu_mm = 0\n"},
    {"PlaneAndBar",
     "[[measure]]\nwith = \"flat_surface\"\nplacements = 1\nu_mm = 0\n[[measure]]\nwith = "
     "\"two_seats\"\npostures = 20\nu_mm = 0\nu_length_mm = 0\n"},
    {"Platform",
     "[[measure]]\nwith = \"indexed_platform\"\npoints = 8\nu_mm = 0\nu_index_arcsec = 0\n"},
    {"HalfTurnsAndCircles",
     "[[measure]]\nwith = \"half_turns\"\ncount = 40\nu_mm = 0\n[[measure]]\nwith = "
     "\"circle_radii\"\ncount = 30\nu_mm = 0\n"},
};

// Simulates a scenario into files of a folder. @return the simulation and the session's path
std::pair<Simulation, SimulationFiles> simulated(const testing::TemporaryFolder& folder,
                                                 const std::string& scenario) {
  folder.write("drawing.arm.toml", arm_text(testing::nominal_romer()));
  const std::string path = folder.write("kit.scenario.toml", scenario);
  InputFiles files;
  const LoadedScenario loaded = load_scenario(files, path);
  Simulation simulation = simulate(loaded, loaded.scenario.seed);
  SimulationFiles written = simulation_files(simulation, loaded.scenario);
  write_simulation(written, folder.path("out"), Overwrite::refuse);
  return {std::move(simulation), std::move(written)};
}

class SimulatedFiles : public ::testing::TestWithParam<Kit> {};

TEST_P(SimulatedFiles, CalibrateToTheTruth) {
  const testing::TemporaryFolder folder;
  const auto [simulation, written] =
      simulated(folder, std::string("schema = \"armcal.scenario/1\"\narm = "
                                    "\"drawing.arm.toml\"\n[errors.geometry]\ntypical = "
                                    "true\n") +
                            GetParam().measurements + "[check]\npoints = 50\n");
  InputFiles files;
  const LoadedSession session = load_session(files, folder.path("out/" + written.session));
  const Calibration calibration = run_calibration(session);
  EXPECT_LT(check_against_truth(calibration.arm, simulation).max_mm, 1e-6);
  const Eigen::VectorXd truth = true_values(calibration, simulation.truth);
  int compared = 0;
  for (const int index : calibration.free) {
    const CalibratedParameter& each = calibration.parameters[static_cast<std::size_t>(index)];
    if (std::isnan(truth(index))) continue;
    EXPECT_NEAR(each.value, truth(index), each.unit == ParameterUnit::mm ? 1e-6 : 1e-9)
        << each.name;
    ++compared;
  }
  EXPECT_GE(compared, 4 * calibration.arm.joint_count() - 3);
}

INSTANTIATE_TEST_SUITE_P(Of, SimulatedFiles, ::testing::ValuesIn(kKits),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(SimulatedProcedure, IsAdjustedToTheTruth) {
  const testing::TemporaryFolder folder;
  // Wrong only in what the procedure of the paper determines.
  ArmModel truth = testing::consistent_romer();
  truth.joints[1].zero_rad = 2e-4;
  truth.joints[3].zero_rad = -3e-4;
  folder.write("true.arm.toml", arm_text(truth));
  const auto [simulation, written] =
      simulated(folder,
                "schema = \"armcal.scenario/1\"\narm = \"drawing.arm.toml\"\ntruth = "
                "\"true.arm.toml\"\n[[measure]]\nwith = \"symmetric_point\"\nu_point_mm = 0\n");
  EXPECT_EQ(written.session, "");
  ASSERT_EQ(written.procedures.size(), 1u);
  InputFiles files;
  const SymmetricPointAnalysis analysis =
      run_symmetric_point(files, folder.path("out/" + written.procedures[0]), std::nullopt, {});
  const ParameterTable table(truth);
  const Eigen::VectorXd found = parameter_values(analysis.adjustment.arm);
  const Eigen::VectorXd expected = parameter_values(truth);
  for (const char* name : {"a5", "a7", "b3", "b5", "b7", "zero2", "zero4"}) {
    const int index = table.find(name).value();
    const double tolerance = table[index].unit == ParameterUnit::mm ? 1e-6 : 1e-9;
    EXPECT_NEAR(found(index), expected(index), tolerance) << name;
  }
}

TEST(WrittenSimulation, NeverOverwritesUnlessTold) {
  const testing::TemporaryFolder folder;
  const SimulationFiles files{{{"a.csv", "1"}, {"sub/b.csv", "2"}}, "", {}};
  write_simulation(files, folder.path("out"), Overwrite::refuse);
  EXPECT_EQ(testing::read_bytes(folder.path("out/sub/b.csv")), "2");
  const SimulationFiles others{{{"c.csv", "3"}, {"a.csv", "4"}}, "", {}};
  EXPECT_THROW(write_simulation(others, folder.path("out"), Overwrite::refuse), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/c.csv")));  // all or nothing
  write_simulation(others, folder.path("out"), Overwrite::allow);
  EXPECT_EQ(testing::read_bytes(folder.path("out/a.csv")), "4");
  EXPECT_THROW(write_simulation(files, folder.path("out/a.csv"), Overwrite::allow), InputError);
}

}  // namespace
}  // namespace armcal
