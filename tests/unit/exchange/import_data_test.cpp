// Real clips and characters beside the repository.

#include <gtest/gtest.h>

#include "engine/analysis/flights.h"
#include "engine/bake/bake.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "engine/project/compile.h"
#include "tests/support/data_folder.h"

namespace hazumi::test {
namespace {

Imported ImportFile(const std::string& file, const ImportOptions& options = {}) {
  const Result<Character> character = ReadCharacter(DataPath(file));
  EXPECT_TRUE(character.ok()) << character.error().ToString();
  if (!character.ok()) return {};
  Result<Imported> imported = ImportProject(character.value(), options);
  EXPECT_TRUE(imported.ok()) << imported.error().ToString();
  return imported.ok() ? std::move(imported).value() : Imported();
}

class ImportData : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"jump", "throw", "other", "characters"}) HAZUMI_NEED_DATA(folder);
  }
};

TEST_F(ImportData, PeopleAreAsTallAsPeople) {
  for (const char* file :
       {"jump/cmu_amc2bvh_16_01_jump_WRONGFPS.bvh", "jump/cmu_daz_13_39_jump.bvh",
        "jump/cmu_mb_02_04_jump_balance.bvh", "jump/fair_jumping_zup.bvh",
        "other/bvhtoolbox_walk01.bvh", "other/cmu_mb_02_01_walk.bvh",
        "other/pybvh_standard_skeleton.bvh", "throw/cmu_mb_06_14_basketball_shoot.bvh",
        "throw/cmu_mb_124_01_baseball_pitch.bvh", "characters/khronos_cesium_man.gltf",
        "characters/ozz_pab_arnaud.fbx"}) {
    const ImportReport report = ImportFile(file).report;
    EXPECT_GT(report.height_m, 1.4) << file;
    EXPECT_LT(report.height_m, 1.95) << file;
    EXPECT_LT(report.position_error_m, 1e-4) << file;
  }
}

TEST_F(ImportData, UpIsWhereTheHeadIs) {
  EXPECT_EQ(ImportFile("jump/fair_jumping_zup.bvh").report.up, UpAxis::kZ);
  EXPECT_EQ(ImportFile("other/pybvh_standard_skeleton.bvh").report.up, UpAxis::kZ);
  EXPECT_EQ(ImportFile("jump/cmu_daz_13_39_jump.bvh").report.up, UpAxis::kY);
}

FlightAnalysis FlightsOf(const std::string& file, const ImportOptions& options) {
  const Imported imported = ImportFile(file, options);
  const Result<Compiled> compiled = CompileAnimation(imported.project);
  if (!compiled.ok()) return {};
  const Result<Motion> motion = Bake(compiled.value().animation);
  if (!motion.ok()) return {};
  MotionSeries series = SeriesOf(*compiled.value().animation.figure, motion.value());
  series.scale_known = !imported.project.size_is_guessed;
  return AnalyseFlights(series);
}

// Frames as they were read off the force of the feet and the height of the CoM, at 120 Hz.
TEST_F(ImportData, FlightsAreWhereTheyWereMeasured) {
  struct Clip {
    const char* file;
    std::optional<double> unit;  // [m], as far as it is stated
    double take_off, apex, landing;
  };
  const Clip clips[] = {
      {"jump/cmu_mb_02_04_jump_balance.bvh", 0.056444, 109.0, 143.3, 178.0},
      {"jump/cmu_daz_13_39_jump.bvh", 0.01035, 159.0, 191.9, 225.0},
      {"jump/cmu_amc2bvh_16_01_jump_WRONGFPS.bvh", std::nullopt, 124.0, 150.8, 177.0}};
  for (const Clip& clip : clips) {
    SCOPED_TRACE(clip.file);
    ImportOptions options;
    options.metres_per_unit = clip.unit;
    const FlightAnalysis analysis = FlightsOf(clip.file, options);
    ASSERT_EQ(analysis.flights.size(), 1u);
    EXPECT_NEAR(analysis.flights[0].take_off, clip.take_off, 2.0);
    EXPECT_NEAR(analysis.flights[0].apex, clip.apex, 2.0);
    EXPECT_NEAR(analysis.flights[0].landing, clip.landing, 2.0);
    if (clip.unit) {
      EXPECT_NEAR(analysis.time.gravity, 9.81, 0.03 * 9.81);
    } else {
      EXPECT_EQ(analysis.time.verdict, TimeVerdict::kWrongFrameTime);
      EXPECT_EQ(analysis.time.frame_rate, 120);
    }
  }
}

TEST_F(ImportData, WhereTheUnitIsNotStatedGravitySaysHowLongItIs) {
  const TimeScale time = FlightsOf("jump/fair_jumping_zup.bvh", {}).time;
  EXPECT_EQ(time.verdict, TimeVerdict::kWrongLength);
  const double unit = ImportFile("jump/fair_jumping_zup.bvh").report.metres_per_unit;
  EXPECT_NEAR(unit * time.length_factor, 0.0271, 0.08 * 0.0271);
  EXPECT_FALSE(LengthFactorRange(time).Contains(1.0));
}

TEST_F(ImportData, WhoWalksOrThrowsDoesNotFly) {
  for (const char* file :
       {"other/cmu_mb_02_01_walk.bvh", "other/bvhtoolbox_walk01.bvh", "wild/cmu_mb_07_01_walk.bvh",
        "throw/cmu_mb_124_01_baseball_pitch.bvh", "throw/cmu_mb_06_14_basketball_shoot.bvh"}) {
    const FlightAnalysis analysis = FlightsOf(file, {});
    EXPECT_TRUE(analysis.flights.empty()) << file;
    EXPECT_EQ(analysis.time.verdict, TimeVerdict::kUnknown) << file;
  }
}

// No foot is on the ground on frames 37 to 57, 75 to 104 and 122 to 150: a foot that rolls off its
// toes is not up 2 cm for some frames.
TEST_F(ImportData, ARunFliesAtEachStepAndItsGravityIsThatOfTheEarth) {
  const FlightAnalysis run = FlightsOf("wild/cmu_mb_02_03_run.bvh", {});
  ASSERT_EQ(run.flights.size(), 3u);
  const double take_offs[] = {37.0, 75.0, 122.0}, landings[] = {57.0, 104.0, 150.0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT(run.flights[i].take_off, take_offs[i] - 2.0) << i;
    EXPECT_LT(run.flights[i].take_off, take_offs[i] + 8.0) << i;
    EXPECT_NEAR(run.flights[i].landing, landings[i], 2.0) << i;
    EXPECT_TRUE(run.flights[i].gravity.Interval().Contains(9.81)) << i;
  }
  EXPECT_TRUE(run.time.gravity_range.Contains(9.81));
  EXPECT_EQ(run.time.verdict, TimeVerdict::kTrue);
}

// The leg that kicks goes up by two metres: where masses are wrong, so is its parabola.
TEST_F(ImportData, AJumpKickIsFoundBesideTheJumpBeforeIt) {
  const FlightAnalysis kick = FlightsOf("wild/cmu_mb_90_05_jump_kick.bvh", {});
  ASSERT_EQ(kick.flights.size(), 2u);
  EXPECT_GT(kick.flights[0].take_off, 158.0);
  EXPECT_LT(kick.flights[0].landing, 213.0);
  EXPECT_GT(kick.flights[1].take_off, 239.0);
  EXPECT_NEAR(kick.flights[1].landing, 314.0, 2.0);
  EXPECT_EQ(kick.time.verdict, TimeVerdict::kTrue);
}

TEST(ImportReports, ARootThatJumpsIsNamedWithItsFrame) {
  HAZUMI_NEED_DATA("reports");
  const auto has_jump = [](const ImportReport& report) {
    return std::any_of(report.warnings.begin(), report.warnings.end(), [](const Warning& warning) {
      return warning.message.find("jumps by") != std::string::npos;
    });
  };
  EXPECT_TRUE(has_jump(ImportFile("reports/b09_root_jumps_5m.bvh").report));
  EXPECT_FALSE(has_jump(ImportFile("reports/b00_control.bvh").report));
}

// The armature is a quarter longer along y: thighs of 0.42 m are of 0.525 m at rest. Where they
// turn they cannot be so in all frames, which is said.
TEST(ImportReports, UnevenScalesAreExactAtRest) {
  HAZUMI_NEED_DATA("reports");
  const Imported imported = ImportFile("reports/g11_parent_scaled_unevenly.gltf");
  for (const JointSpec& joint : imported.project.figure.spec.joints) {
    const bool is_below_thigh = joint.name == "LeftLeg" || joint.name == "LeftFoot";
    if (is_below_thigh) {
      EXPECT_NEAR(joint.offset.norm(), 0.525, 1e-6) << joint.name;
    }
  }
  EXPECT_GT(imported.report.position_error_m, 0.1);
  const auto& facts = imported.report.facts;
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [](const std::string& fact) {
    return fact.find("cm from where the file has them") != std::string::npos;
  }));
}

TEST_F(ImportData, TheLongClipIsReducedToAnEighthOfItsKeys) {
  const std::string clip = "jump/cmu_mb_02_04_jump_balance.bvh";
  ImportOptions options;
  EXPECT_EQ(ImportFile(clip, options).report.num_keys, 34872);
  options.reduce_deg = 1.0;
  const ImportReport report = ImportFile(clip, options).report;
  EXPECT_LT(report.num_keys, 34872 / 8);
  EXPECT_LE(report.position_error_m, 0.05);
}

}  // namespace
}  // namespace hazumi::test
