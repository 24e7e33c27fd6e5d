// What the parts of the people beside the repository weigh.

#include <gtest/gtest.h>

#include <cstdio>

#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "tests/support/data_folder.h"
#include "tests/unit/exchange/mass_oracle.h"

namespace hazumi::test {
namespace {

// Those whose bones say what they are, with every segment of the table and a head like people's.
const std::vector<std::string> kPeople = {"characters/ozz_pab_arnaud.fbx",
                                          "jump/cmu_amc2bvh_16_01_jump_WRONGFPS.bvh",
                                          "jump/cmu_daz_13_39_jump.bvh",
                                          "jump/cmu_mb_02_04_jump_balance.bvh",
                                          "jump/fair_jumping_zup.bvh",
                                          "other/bvhtoolbox_walk01.bvh",
                                          "other/cmu_mb_02_01_walk.bvh",
                                          "other/pybvh_standard_skeleton.bvh",
                                          "throw/cmu_mb_06_14_basketball_shoot.bvh",
                                          "throw/cmu_mb_124_01_baseball_pitch.bvh",
                                          "wild/cmu_mb_02_03_run.bvh",
                                          "wild/cmu_mb_07_01_walk.bvh",
                                          "wild/cmu_mb_90_05_jump_kick.bvh",
                                          "wild/ozz_pab_skeleton.dae",
                                          "wild/ozz_pab_walk.fbx"};

std::map<std::string, double> SharesOfFile(const std::string& file) {
  const Result<Character> character = ReadCharacter(DataPath(file));
  EXPECT_TRUE(character.ok()) << character.error().ToString();
  if (!character.ok()) return {};
  const Result<Imported> imported = ImportProject(character.value(), {});
  EXPECT_TRUE(imported.ok()) << file << ": " << imported.error().ToString();
  return imported.ok() ? SharesOf(imported.value().project.figure.spec)
                       : std::map<std::string, double>();
}

void PrintRow(const std::string& name, const std::map<std::string, double>& shares) {
  std::printf("| %s |", name.c_str());
  for (const auto& [segment, share] : kDeLeva) {
    const auto found = shares.find(segment);
    if (found == shares.end()) {
      std::printf("  |");
    } else {
      std::printf(" %.2f |", found->second);
    }
  }
  std::printf("\n");
}

TEST(MassData, SharesOfEveryClipAndCharacterAreTheTables) {
  for (const std::string& file : kPeople) {
    HAZUMI_NEED_DATA(file);
  }
  std::printf("| %% |");
  for (const auto& [segment, share] : kDeLeva) std::printf(" %s |", segment.c_str());
  std::printf("\n");
  PrintRow("de Leva 1996", kDeLeva);
  for (const std::string& file : kPeople) {
    SCOPED_TRACE(file);
    const std::map<std::string, double> shares = SharesOfFile(file);
    PrintRow(file, shares);
    EXPECT_EQ(shares.size(), kDeLeva.size());
    for (const auto& [segment, share] : shares) {
      ASSERT_TRUE(kDeLeva.contains(segment)) << segment;
      EXPECT_NEAR(share, kDeLeva.at(segment), 0.2) << segment;
    }
  }
}

}  // namespace
}  // namespace hazumi::test
