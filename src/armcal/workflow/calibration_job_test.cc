// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/calibration_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/core/units.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

Calibration calibrated(const std::string& path) {
  InputFiles files;
  return run_calibration(load_session(files, path));
}

// Sessions of measured arms: they read the reference data where these lie, beside the repository.
class RealArms : public ::testing::Test {
 protected:
  static Calibration of(const std::string& name) {
    return calibrated(
        (testing::repository() / "examples/real" / (name + ".session.toml")).string());
  }
  void SetUp() override {
    if (!std::filesystem::exists(testing::repository() / "../shared/data/real")) {
      GTEST_SKIP() << "no measured data beside the repository (../shared/data/real)";
    }
  }
};

// Root mean square over the held-out rows of all groups, lengths apart.
double check_rms(const Calibration& calibration) {
  double squares = 0.0;
  double count = 0.0;
  for (const GroupResult& group : calibration.groups) {
    if (!group.check || group.kind == ReferenceKind::length) continue;
    squares += std::pow(group.check->rms_mm, 2) * static_cast<double>(group.check->count);
    count += static_cast<double>(group.check->count);
  }
  return std::sqrt(squares / count);
}

// Either the predicted regions hold, or the report says that the model is too small (below 90 %).
void expect_honest_coverage(const Calibration& calibration) {
  ASSERT_TRUE(calibration.check_coverage.has_value());
  EXPECT_LE(*calibration.check_coverage, 0.98);
}

TEST_F(RealArms, Ur10WithATrackerOnHeldOutPostures) {
  const Calibration calibration = of("ur10-series-b");
  EXPECT_LE(check_rms(calibration), 0.43);
  expect_honest_coverage(calibration);
  // Parallel axes: no lengths of hundreds of metres, and the measurement that is printed twice is
  // named.
  for (const CalibratedParameter& each : calibration.parameters) {
    if (each.unit == ParameterUnit::mm) {
      EXPECT_LT(std::abs(each.value - each.nominal), 100.0) << each.name;
    }
  }
}

TEST_F(RealArms, Ur10KinematicsOnAnotherSeries) {
  const Calibration calibration = of("ur10-series-d");
  EXPECT_LE(check_rms(calibration), 0.56);
  expect_honest_coverage(calibration);
}

TEST_F(RealArms, PandaWithABallInSocketsOnOtherPositions) {
  const Calibration calibration = of("panda");
  EXPECT_LE(check_rms(calibration), 0.275);
  expect_honest_coverage(calibration);
  double lengths = 0.0;
  int count = 0;
  for (const GroupResult& group : calibration.groups) {
    if (!group.check || group.kind != ReferenceKind::length) continue;
    lengths += group.check->mean_mm;
    ++count;
  }
  EXPECT_EQ(count, 5);
  EXPECT_LE(lengths / count, 0.06);
}

TEST_F(RealArms, PositionerByOriginsAndByPoses) {
  for (const char* name : {"positioner", "positioner-poses"}) {
    const Calibration calibration = of(name);
    EXPECT_LE(calibration.groups[0].check->mean_mm, 0.39) << name;
    expect_honest_coverage(calibration);
  }
}

// A session in a folder of its own, with a two-joint arm.
class Sessions : public ::testing::Test {
 protected:
  Sessions() {
    folder_.write(
        "arm.arm.toml",
        "schema = 'armcal.arm/1'\n[[link]]\nb_mm = 300\nalpha_deg = 90\n[tip]\na_mm = 200\n");
  }

  // Message of the failure.
  std::string complaint(const std::string& observations) {
    const std::string path = folder_.write(
        "s.session.toml",
        "schema = 'armcal.session/1'\narm = 'arm.arm.toml'\nangles = 'deg'\n" + observations);
    try {
      static_cast<void>(calibrated(path));
    } catch (const InputError& error) {
      return error.what();
    } catch (const NumericalError& error) {
      return std::string("numerical: ") + error.what();
    }
    return "";
  }

  std::string points(const std::string& rows) {
    folder_.write("p.csv", "q1_deg,q2_deg,x_mm,y_mm,z_mm\n" + rows);
    return "[[observations]]\nkind = 'reference_points'\nfile = 'p.csv'\nu_mm = 0.1\n";
  }

  testing::TemporaryFolder folder_;
};

const char* const kRows =
    "0,0,200,300,0\n90,0,-300,200,0\n0,90,0,300,200\n45,45,-112.13,312.13,141.42\n10,-60,45.8,312."
    "8,-173.2\n";

TEST_F(Sessions, WithSoundReadingsCalibrate) { EXPECT_EQ(complaint(points(kRows)), ""); }

TEST_F(Sessions, WithOneRowOrTwoPointsPerSetUpSayWhatIsMissing) {
  EXPECT_THAT(complaint(points("0,0,200,300,0\n90,10,-300,200,0\n")),
              HasSubstr("setup.p cannot be placed by its 2 points"));
  EXPECT_THAT(complaint(points("0,0,200,300,0\n")), HasSubstr("no joint moves"));
}

TEST_F(Sessions, WithRowsCopiedTwiceNameTheLine) {
  EXPECT_THAT(complaint(points(std::string(kRows) + "0,0,200,300,0\n")), HasSubstr("p.csv:7"));
}

TEST_F(Sessions, WithUncertaintiesThatAreNoneComplain) {
  for (const char* u : {"0", "-0.1"}) {
    std::string session = points(kRows);
    session.replace(session.find("0.1"), 3, u);
    EXPECT_THAT(complaint(session), HasSubstr("must be larger than 0")) << u;
  }
  std::string session = points(kRows);
  session.erase(session.find("u_mm"));
  EXPECT_THAT(complaint(session), HasSubstr("have no uncertainty"));
}

// Weights from the session: of encoders for all, and for one table that says otherwise.
TEST_F(Sessions, TellHowUncertainTheEncodersAre) {
  const std::string head = "schema = 'armcal.session/1'\narm = 'arm.arm.toml'\nangles = 'deg'\n";
  const auto u_encoders = [&](const std::string& top, const std::string& of_group) {
    std::string session = points(kRows) + of_group;
    session += "[[observations]]\nkind = 'length'\nfrom = 'A'\nto = 'B'\nlength_mm = 9\nu_mm = 1\n";
    InputFiles files;
    const auto loaded = load_session(files, folder_.write("s.session.toml", head + top + session));
    return loaded.groups[0].u_encoder_rad / radians_from_arcseconds(1.0);
  };
  EXPECT_EQ(u_encoders("", ""), 0.0);
  EXPECT_NEAR(u_encoders("u_encoder_arcsec = 2\n", ""), 2.0, 1e-12);
  EXPECT_NEAR(u_encoders("u_encoder_arcsec = 2\n", "u_encoder_arcsec = 5\n"), 5.0, 1e-12);
  EXPECT_EQ(u_encoders("u_encoder_arcsec = 2\n", "u_encoder_arcsec = 0\n"), 0.0);
  EXPECT_THAT(complaint(points(kRows) + "u_encoder_arcsec = -1\n"),
              HasSubstr("u_encoder_arcsec is -1: must not be negative"));
}

TEST_F(Sessions, WithJointsThatStandStillComplain) {
  EXPECT_THAT(complaint(points("0,5,200,300,0\n90,5,-300,200,0\n40,5,0,300,200\n")),
              HasSubstr("joint 2 never moves"));
  EXPECT_THAT(complaint(points("0,0,200,300,0\n0,0,-300,200,0\n0,0,0,300,200\n")),
              HasSubstr("no joint moves"));
}

TEST_F(Sessions, WithArtefactsThatLackAFeatureNameIt) {
  folder_.write("plate.csv", "feature,x_mm,y_mm,z_mm\nS1,0,0,0\nS2,100,0,0\nS3,0,100,0\n");
  folder_.write("a.csv", "feature,q1_deg,q2_deg\nS1,0,0\nS2,90,10\nS4,20,30\n");
  const std::string session =
      "[[observations]]\nkind = 'artefact'\nfile = 'a.csv'\nartefact = 'plate.csv'\nu_mm = 0.1\n";
  EXPECT_THAT(complaint(session), HasSubstr("has no feature \"S4\""));
  folder_.write("plate.csv",
                "feature,x_mm,y_mm,z_mm\nS1,0,0,0\nS2,100,0,0\nS4,0,100,0\nS2,50,0,0\n");
  EXPECT_THAT(complaint(session), HasSubstr("the feature \"S2\" is there twice"));
}

TEST_F(Sessions, WithFixedPointsOnlySayThatSizeIsUnknown) {
  folder_.write("f.csv", "q1_deg,q2_deg\n0,0\n10,20\n30,-40\n-50,60\n");
  EXPECT_THAT(
      complaint(
          "[[observations]]\nkind = 'fixed_point'\nfile = 'f.csv'\npoint = 'cone'\nu_mm = 0.1\n"),
      HasSubstr("numerical: "));
}

TEST_F(Sessions, WithUnknownKindsKeysAndNamesHelp) {
  EXPECT_THAT(complaint("[[observations]]\nkind = 'reference_point'\nfile = 'p.csv'\nu_mm = 1\n"),
              HasSubstr("did you mean \"reference_points\"?"));
  EXPECT_THAT(complaint(points(kRows) + "uncertainty = 3\n"),
              HasSubstr("unknown key \"uncertainty\""));
  EXPECT_THAT(complaint(points(kRows) + "[estimate]\nhold = ['gamma*']\n"),
              HasSubstr("no parameter matches \"gamma*\""));
  EXPECT_THAT(complaint(points(kRows) + "[estimate]\nprior = { length_m = 1 }\n"),
              HasSubstr("unknown prior"));
  EXPECT_THAT(complaint(""), HasSubstr("has no observations"));
}

}  // namespace
}  // namespace armcal
