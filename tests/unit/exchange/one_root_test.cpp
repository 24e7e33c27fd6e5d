// Characters whose bones have several roots.

#include "engine/exchange/import/one_root.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/exchange/import/skeleton.h"
#include "tests/unit/exchange/made_characters.h"

namespace hazumi::test {
namespace {

// On a still "rig": a leg, and hips that travel, with a spine on them. All turn.
Character Split() {
  Character character;
  character.up = UpAxis::kZ;
  character.metres_per_unit = 1.0;
  const auto add = [&](const std::string& name, int parent, const Vec3& p) {
    Bone bone;
    bone.name = name;
    bone.parent = parent;
    bone.rest.p = p;
    bone.rest.R = Mat3(Eigen::AngleAxisd(0.3 * p.z(), Vec3::UnitX()));
    bone.is_joint = name != "rig";
    character.bones.push_back(bone);
  };
  add("rig", -1, Vec3(0.0, 0.0, 0.1));
  add("leg", 0, Vec3(0.1, 0.0, 0.9));
  add("shin", 1, Vec3(0.0, 0.0, -0.4));
  add("hips", 0, Vec3(0.0, 0.0, 1.0));
  add("spine", 3, Vec3(0.0, 0.0, 0.2));
  add("head", 4, Vec3(0.0, 0.0, 0.4));
  Clip clip{"walk", 1.0 / 30.0, 20, std::vector<BoneTrack>(character.bones.size())};
  for (size_t b = 1; b < character.bones.size(); ++b) {
    for (int f = 0; f < clip.num_frames; ++f) {
      const double angle = 0.2 * std::sin(0.4 * f + static_cast<double>(b));
      clip.tracks[b].rotations.emplace_back(character.bones[b].rest.R *
                                            Eigen::AngleAxisd(angle, Vec3::UnitY()));
      if (b == 1 || b == 3)
        clip.tracks[b].translations.push_back(character.bones[b].rest.p + Vec3(0.05 * f, 0.0, 0.0));
    }
  }
  character.clips.push_back(clip);
  return character;
}

int IndexOf(const std::string& name, const Character& character) {
  const auto found = std::find_if(character.bones.begin(), character.bones.end(),
                                  [&](const Bone& bone) { return bone.name == name; });
  return static_cast<int>(found - character.bones.begin());
}

TEST(OneRoot, EveryFrameShowsAllWhereTheyWere) {
  const Character split = Split();
  const auto hung = WithOneRoot(WantedBones(split), split);
  ASSERT_TRUE(hung);
  const Clip *before = &split.clips[0], *after = &hung->clips[0];
  for (int frame = -1; frame < before->num_frames; ++frame) {
    const auto old_poses = PosesAt(split, frame < 0 ? nullptr : before, std::max(frame, 0));
    const auto new_poses = PosesAt(*hung, frame < 0 ? nullptr : after, std::max(frame, 0));
    for (size_t b = 0; b < split.bones.size(); ++b) {
      const BonePose& is = new_poses[IndexOf(split.bones[b].name, *hung)];
      EXPECT_LT((is.p - old_poses[b].p).norm(), 1e-12) << split.bones[b].name << " " << frame;
      EXPECT_LT((is.R - old_poses[b].R).norm(), 1e-12) << split.bones[b].name << " " << frame;
    }
  }
  for (size_t b = 0; b < hung->bones.size(); ++b)
    EXPECT_LT(hung->bones[b].parent, static_cast<int>(b));
  EXPECT_EQ(hung->bones[IndexOf("leg", *hung)].parent, IndexOf("hips", *hung));
}

TEST(OneRoot, TheFigureTravelsAndSaysWhatHangsOnIt) {
  const Imported imported = ImportWell(Split(), {});
  EXPECT_EQ(imported.project.figure.spec.root_name, "hips");
  EXPECT_GT(imported.project.root.curves[kRootX].keys.size(), 1u);
  const auto& warnings = imported.report.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.place == "hips" &&
           warning.message ==
               "is taken as the root of several; on it hang now, at a fixed distance: leg";
  }));
}

TEST(OneRoot, ARootThatCarriesAllOrBranchesThatStayAreLeftAlone) {
  Character still = Split();
  for (BoneTrack& track : still.clips[0].tracks) track.translations.clear();
  EXPECT_FALSE(WithOneRoot(WantedBones(still), still));
  Character moved = Split();
  moved.bones[0].is_joint = true;
  EXPECT_FALSE(WithOneRoot(WantedBones(moved), moved));
}

}  // namespace
}  // namespace hazumi::test
