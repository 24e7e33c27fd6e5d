// Real clips and characters beside the repository.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"

namespace hazumi::test {
namespace {

const std::string kData = HAZUMI_SHARED_DIR "/data/";

Imported ImportFile(const std::string& file, const ImportOptions& options = {}) {
  const Result<Character> character = ReadCharacter(kData + file);
  EXPECT_TRUE(character.ok()) << character.error().ToString();
  if (!character.ok()) return {};
  Result<Imported> imported = ImportProject(character.value(), options);
  EXPECT_TRUE(imported.ok()) << imported.error().ToString();
  return imported.ok() ? std::move(imported).value() : Imported();
}

class ImportData : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kData + "jump")) GTEST_SKIP() << "skipped: no data";
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

TEST_F(ImportData, TheLongClipTakesLessThanASecondAlsoWithFewKeys) {
  using Clock = std::chrono::steady_clock;
  ImportOptions options;
  for (const bool is_reduced : {false, true}) {
    if (is_reduced) options.reduce_deg = 1.0;
    const auto start = Clock::now();
    const Imported imported = ImportFile("jump/cmu_mb_02_04_jump_balance.bvh", options);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    EXPECT_LT(seconds, 1.0);
    RecordProperty(is_reduced ? "reduced_keys" : "keys", imported.report.num_keys);
    std::printf("%d keys, %.3f s, joints within %.2f cm\n", imported.report.num_keys, seconds,
                100.0 * imported.report.position_error_m);
    if (is_reduced) {
      EXPECT_LT(imported.report.num_keys, 36804 / 8);
    }
  }
}

}  // namespace
}  // namespace hazumi::test
