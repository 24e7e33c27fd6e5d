// What an import makes can be written, read again and baked, or it is refused: nothing is saved
// that could not be opened.

#include <gtest/gtest.h>

#include <set>

#include "engine/bake/bake.h"
#include "engine/exchange/character/character_check.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

// Why a project that was made cannot be opened; empty: it can, or none was made.
std::string WhyLost(const Character& character, const ImportOptions& options = {}) {
  const Result<Imported> imported = ImportProject(character, options);
  if (!imported.ok()) return "";
  const Result<Project> read = ParseProject(WriteProject(imported.value().project), "saved.kfa");
  if (!read.ok()) return "read: " + read.error().ToString();
  const Result<Compiled> compiled = CompileAnimation(read.value());
  if (!compiled.ok()) return "compile: " + compiled.error().ToString();
  const Result<Motion> motion = Bake(compiled.value().animation, {});
  return motion.ok() ? "" : "bake: " + motion.error().ToString();
}

void ScaleBy(double factor, Character* character) {
  for (Bone& bone : character->bones) bone.rest.p *= factor;
  for (Clip& clip : character->clips)
    for (BoneTrack& track : clip.tracks)
      for (Vec3& p : track.translations) p *= factor;
}

constexpr const char* kOddNames[] = {
    "",           "+",           "++",       "a+",      "root", "ground", "hips", "Hips_x",
    "_x",         "\x01\x02",    "\xff\xfe", "弾み",    "a b",  "a/b",    "a.b",  "a[0]",
    "\"quoted\"", "back\\slash", "x",        "default", "\n",   " ",      "."};

std::string OddName(Random* random) {
  const int i = random->Integer(0, static_cast<int>(std::size(kOddNames)) + 2);
  if (i < static_cast<int>(std::size(kOddNames))) return kOddNames[i];
  std::string name;
  while (name.size() < 199) name += i % 2 ? "n" : "弾";
  name += "弾+";
  return name;
}

ImportOptions RandomOptions(Random* random) {
  ImportOptions options;
  if (random->Chance(0.2)) options.height_m = random->LogUniform(1e-9, 1e9);
  if (random->Chance(0.2)) options.mass_kg = random->LogUniform(1e-12, 1e12);
  if (random->Chance(0.2)) options.fps = random->LogUniform(1e-4, 1e6);
  if (random->Chance(0.2)) options.metres_per_unit = random->LogUniform(1e-12, 1e6);
  if (random->Chance(0.3)) options.reduce_deg = random->LogUniform(1e-6, 90.0);
  if (random->Chance(0.3)) options.limits = ImportLimits::kNone;
  return options;
}

void GiveOddNames(Random* random, Character* character) {
  std::set<std::string> used;
  for (Bone& bone : character->bones) {
    std::string name = OddName(random);
    if (name.empty() || used.contains(name)) name += std::to_string(used.size());
    used.insert(name);
    bone.name = name;
  }
}

// Angles as BVH has them, up to many turns.
void GiveAngles(Random* random, Character* character) {
  Clip& clip = character->clips[0];
  const double most = random->LogUniform(1.0, 1e5);  // [rad]
  for (size_t b = 1; b < character->bones.size(); ++b) {
    character->bones[b].rotation_order = "ZYX";
    character->bones[b].rest.R.setIdentity();
    for (int f = 0; f < clip.num_frames; ++f)
      clip.tracks[b].angles.push_back(random->Vector3(most));
  }
}

Character OddCharacter(Random* random) {
  Character c = RandomCharacter(random, random->Integer(2, 8), random->Integer(1, 6));
  if (random->Chance(0.3)) AddSkin(random, &c);
  if (random->Chance(0.5)) c.metres_per_unit.reset();
  if (random->Chance(0.5)) c.up.reset();
  if (random->Chance(0.6)) ScaleBy(random->LogUniform(1e-15, 1e9), &c);
  if (random->Chance(0.3)) c.clips[0].seconds_per_frame = random->LogUniform(1e-5, 1e2);
  if (random->Chance(0.3)) {
    const double scale = random->LogUniform(1e-12, 1e9);
    for (Bone& bone : c.bones) bone.rest_scale = Vec3::Constant(scale);
  }
  if (random->Chance(0.3)) GiveOddNames(random, &c);
  if (random->Chance(0.2)) GiveAngles(random, &c);
  if (random->Chance(0.2)) c.name = OddName(random);
  if (random->Chance(0.1)) ScaleBy(0.0, &c);
  if (random->Chance(0.1)) c.clips.clear();
  return c;
}

TEST(ImportSaved, WhatAnImportMakesCanBeOpened) {
  int made = 0, refused = 0;
  for (uint64_t seed = 1; seed <= 600; ++seed) {
    Random random(seed);
    const Character character = OddCharacter(&random);
    if (!CheckCharacter(character, "odd").ok()) continue;  // no reader gives it
    const ImportOptions options = RandomOptions(&random);
    EXPECT_EQ(WhyLost(character, options), "") << "seed " << seed;
    ++(ImportProject(character, options).ok() ? made : refused);
  }
  EXPECT_GT(made, 100);
  EXPECT_GT(refused, 100);
}

// Of a kilometre it would weigh more than a file can say.
TEST(ImportSaved, AFigureOfKilometresIsRefusedWithItsHeight) {
  Random random(1);
  Character character = RandomCharacter(&random);
  character.metres_per_unit = 1e5;
  const Result<Imported> imported = ImportProject(character, {});
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(imported.error().place, "size");
  EXPECT_NE(imported.error().message.find("100000 m to a unit"), std::string::npos)
      << imported.error().message;
  EXPECT_NE(imported.error().message.find("--height"), std::string::npos);
  ImportOptions options;
  options.height_m = 1.8;
  EXPECT_EQ(WhyLost(character, options), "");
  EXPECT_TRUE(ImportProject(character, options).ok());
}

TEST(ImportSaved, MoreJointsThanAFigureMayHaveAreRefusedWithTheirNumber) {
  Random random(1);
  const Result<Imported> imported = ImportProject(RandomCharacter(&random, 10003, 1), {});
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().message.find("10001 joints"), std::string::npos)
      << imported.error().message;
}

// What it says of clips; empty: nothing.
std::string SaidOfClips(const Character& character, const ImportOptions& options = {}) {
  const std::vector<Warning> warnings = ImportWell(character, options).report.warnings;
  const bool is_first = !warnings.empty() && warnings[0].place == "clip";
  return is_first ? warnings[0].message : "";
}

TEST(ImportSaved, OneClipOfManyIsNotTakenWithoutAWord) {
  Random random(1);
  Character character = RandomCharacter(&random);
  EXPECT_EQ(SaidOfClips(character), "");
  Clip other = character.clips[0];
  const std::string long_name(99, 'n');
  other.name = long_name;
  other.name += "弾";
  character.clips.push_back(other);
  EXPECT_EQ(SaidOfClips(character), "\"clip\" is taken, the first of 2: \"clip\", \"" + long_name +
                                        "...\"; to take another, give its name (--clip NAME)");
  ImportOptions options;
  options.clip = other.name;
  EXPECT_EQ(SaidOfClips(character, options), "");
}

}  // namespace
}  // namespace hazumi::test
