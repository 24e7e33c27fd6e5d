// What an import makes can be written, read again and baked, or it is refused: nothing is saved that
// could not be opened.

#include <gtest/gtest.h>

#include <map>
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

std::string OddName(Random* random) {
  const std::vector<std::string> names = {
      "", "+", "++", "a+", "root", "ground", "pelvis_x", "hips", "Hips_x", "_x", "\x01\x02", "\xff\xfe",
      "弾み", "a b", "a/b", "a.b", "a[0]", "\"quoted\"", "back\\slash", "x", "default", "joints",
      std::string(100000, 'n'), std::string(199, 'a') + "弾", std::string(201, '+'), "\n", " ", "."};
  return names[static_cast<size_t>(random->Integer(0, static_cast<int>(names.size()) - 1))];
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

TEST(ImportSaved, ProbeAll) {
  std::map<std::string, int> seen;
  int made = 0;
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    Random random(seed);
    Character c = RandomCharacter(&random, random.Integer(2, 8), random.Integer(1, 6));
    if (random.Chance(0.3)) AddSkin(&random, &c);
    if (random.Chance(0.5)) c.metres_per_unit.reset();
    if (random.Chance(0.5)) c.up.reset();
    if (random.Chance(0.6)) ScaleBy(random.LogUniform(1e-15, 1e9), &c);
    if (random.Chance(0.3)) c.clips[0].seconds_per_frame = random.LogUniform(1e-6, 1e4);
    if (random.Chance(0.3)) for (Bone& b : c.bones) b.rest_scale = Vec3::Constant(random.LogUniform(1e-12, 1e9));
    if (random.Chance(0.1)) for (Bone& b : c.bones) b.rest.p.setZero();
    if (random.Chance(0.1)) c.clips.clear();
    if (random.Chance(0.2)) c.name = OddName(&random);
    if (random.Chance(0.3)) {
      std::set<std::string> used;
      for (Bone& b : c.bones) {
        std::string n = OddName(&random);
        if (n.empty() || !used.insert(n).second) n += std::to_string(used.size()), used.insert(n);
        b.name = n;
      }
    }
    if (random.Chance(0.2) && !c.clips.empty()) {
      for (size_t b = 1; b < c.bones.size(); ++b) {
        c.bones[b].rotation_order = "ZYX";
        c.bones[b].rest.R.setIdentity();
        c.clips[0].tracks[b].angles.clear();
        for (int f = 0; f < c.clips[0].num_frames; ++f)
          c.clips[0].tracks[b].angles.push_back(random.Vector3(random.LogUniform(1.0, 1e5)));
      }
    }
    if (!CheckCharacter(c, "x").ok()) continue;
    ++made;
    const ImportOptions options = RandomOptions(&random);
    std::string why = WhyLost(c, options);
    if (why.empty()) continue;
    std::string key;
    for (char ch : why) key += std::isdigit(static_cast<unsigned char>(ch)) ? '#' : ch;
    if (key.size() > 160) key = key.substr(0, 80) + "..." + key.substr(key.size() - 80);
    if (++seen[key] == 1) std::printf("%llu: %s\n", (unsigned long long)seed, why.substr(0, 300).c_str());
  }
  std::printf("made %d\n", made);
  for (auto& [k, n] : seen) std::printf("%5d %s\n", n, k.c_str());
}

}  // namespace
}  // namespace hazumi::test
