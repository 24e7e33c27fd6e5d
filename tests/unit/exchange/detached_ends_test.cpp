#include "engine/exchange/import/detached_ends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/exchange/import/skeleton.h"
#include "tests/unit/exchange/made_people.h"

namespace hazumi {
namespace {

Bone At(const std::string& name, int parent, const Vec3& p) {
  Bone bone;
  bone.name = name;
  bone.parent = parent;
  bone.rest.p = p;
  return bone;
}

// A leg of two bones 0.5 long, whose foot hangs beside it on the root, before the leg.
Character Leg() {
  Character c;
  c.bones = {At("root", -1, {0, 0, 1}), At("LeftFoot", 0, {0, 0, -1}),
             At("LeftThigh", 0, {0, 0, 0}), At("LeftShin", 2, {0, 0, -0.5})};
  return c;
}

// The leg swings and bends; the foot goes where it ends, but for the last frames if it lags.
Character Walking(int lags) {
  Character c = Leg();
  Clip clip;
  clip.name = "walk";
  clip.num_frames = 40;
  clip.tracks.resize(4);
  for (int f = 0; f < clip.num_frames; ++f) {
    const Eigen::Quaterniond thigh(Eigen::AngleAxisd(0.6 * std::sin(0.3 * f), Vec3::UnitY()));
    const Eigen::Quaterniond shin(Eigen::AngleAxisd(0.4 - 0.4 * std::cos(0.2 * f), Vec3::UnitY()));
    const Vec3 knee = thigh * Vec3(0, 0, -0.5);
    Vec3 ankle = knee + thigh * shin * Vec3(0, 0, -0.5);
    if (f >= clip.num_frames - lags) ankle.z() -= 0.1;
    clip.tracks[1].translations.push_back(ankle);
    clip.tracks[1].rotations.push_back(Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vec3::UnitX())));
    clip.tracks[2].rotations.push_back(thigh);
    clip.tracks[3].rotations.push_back(shin);
  }
  c.clips = {clip};
  return c;
}

const std::vector<char> kAll(4, 1);

int BoneNamed(const Character& c, const std::string& name) {
  for (size_t b = 0; b < c.bones.size(); ++b)
    if (c.bones[b].name == name) return static_cast<int>(b);
  return -1;
}

TEST(DetachedEnds, FootThatMovesWithAShinIsHungOnItAndStaysWhereItIs) {
  const Character before = Walking(0);
  const auto after = WithEndsOnLimbs(kAll, before);
  ASSERT_TRUE(after);
  const int foot = BoneNamed(*after, "LeftFoot");
  EXPECT_EQ(after->bones[foot].parent, BoneNamed(*after, "LeftShin"));
  EXPECT_LT(after->bones[foot].parent, foot);
  EXPECT_TRUE(after->bones[foot].is_limb_end);
  for (int f = 0; f < 40; ++f) {
    const std::vector<BonePose> old = PosesAt(before, &before.clips[0], f);
    const std::vector<BonePose> now = PosesAt(*after, &after->clips[0], f);
    for (const Bone& bone : before.bones) {
      const BonePose& a = old[static_cast<size_t>(BoneNamed(before, bone.name))];
      const BonePose& b = now[static_cast<size_t>(BoneNamed(*after, bone.name))];
      EXPECT_LT((a.p - b.p).norm(), 1e-12);
      EXPECT_LT((a.R - b.R).norm(), 1e-12);
    }
  }
}

TEST(DetachedEnds, FootThatIsLeftBehindInAFewFramesIsStillTheLegs) {
  EXPECT_TRUE(WithEndsOnLimbs(kAll, Walking(8)));
  EXPECT_FALSE(WithEndsOnLimbs(kAll, Walking(30)));
}

TEST(DetachedEnds, WithoutAClipNamesAndPlacesTell) {
  Character person = test::Person({});
  const std::vector<BonePose> rest = PosesAt(person, nullptr, 0);
  const auto named = [&](const std::string& end) {
    for (size_t b = 0; b < person.bones.size(); ++b)
      if (person.bones[b].name.ends_with(end)) return static_cast<int>(b);
    return -1;
  };
  const int foot = named("LeftFoot"), shin = named("LeftLeg");
  ASSERT_EQ(person.bones[foot].parent, shin);
  const std::vector<char> wanted(person.bones.size(), 1);
  EXPECT_FALSE(WithEndsOnLimbs(wanted, person));
  person.bones[foot].parent = 0;
  person.bones[foot].rest.p = rest[foot].p - rest[0].p;
  const auto after = WithEndsOnLimbs(wanted, person);
  ASSERT_TRUE(after);
  const int now = BoneNamed(*after, person.bones[foot].name);
  EXPECT_EQ(after->bones[after->bones[now].parent].name, person.bones[shin].name);
  // A foot that lies elsewhere is not the shin's.
  person.bones[foot].rest.p.x() += 1.0;
  EXPECT_FALSE(WithEndsOnLimbs(wanted, person));
}

TEST(DetachedEnds, FootOnItsShinStays) {
  Character c = Leg();
  c.bones = {At("root", -1, {0, 0, 1}), At("LeftThigh", 0, {0, 0, 0}),
             At("LeftShin", 1, {0, 0, -0.5}), At("LeftFoot", 2, {0, 0, -0.5})};
  EXPECT_FALSE(WithEndsOnLimbs(kAll, c));
}

TEST(DetachedEnds, WhatNobodyWantsIsLeft) {
  std::vector<char> wanted = kAll;
  wanted[1] = 0;  // a handle
  EXPECT_FALSE(WithEndsOnLimbs(wanted, Walking(0)));
}

// Two feet that stand still beside each other belong to their own legs.
TEST(DetachedEnds, TwoFeetAreNotHungOnEachOther) {
  Character c = Walking(0);
  const int size = static_cast<int>(c.bones.size());
  for (int b = 1; b < size; ++b) {
    Bone other = c.bones[static_cast<size_t>(b)];
    other.name.replace(0, 4, "Right");
    if (other.parent > 0) other.parent += size - 1;
    if (other.parent == 0) other.rest.p.y() -= 0.3;
    c.bones.push_back(other);
    BoneTrack track = c.clips[0].tracks[static_cast<size_t>(b)];
    for (Vec3& p : track.translations) p.y() -= 0.3;
    c.clips[0].tracks.push_back(track);
  }
  const auto after = WithEndsOnLimbs(std::vector<char>(7, 1), c);
  ASSERT_TRUE(after);
  for (const std::string side : {"Left", "Right"}) {
    const int foot = BoneNamed(*after, side + "Foot");
    EXPECT_EQ(after->bones[after->bones[foot].parent].name, side + "Shin");
  }
}

}  // namespace
}  // namespace hazumi
