#include "tests/unit/exchange/bvh_sample.h"

#include <gtest/gtest.h>

namespace hazumi::test {

std::string LastRow() { return "2.5 53 -18 20 0.25 -30 4 5 6 -7 8 9 1 2 -3\n"; }

std::string SmallBvh() {
  return "HIERARCHY\n"
         "ROOT Hips\n"
         "{\n"
         "\tOFFSET 0.5 100.25 0\n"
         "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
         "\tJOINT Spine\n"
         "\t{\n"
         "\t\tOFFSET 0 10 -1.5\n"
         "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
         "\t\tJOINT Head\n"
         "\t\t{\n"
         "\t\t\tOFFSET 0 8 0\n"
         "\t\t\tCHANNELS 3 Yrotation Xrotation Zrotation\n"
         "\t\t\tEnd Site\n"
         "\t\t\t{\n"
         "\t\t\t\tOFFSET 0 4 0\n"
         "\t\t\t}\n"
         "\t\t}\n"
         "\t}\n"
         "\tJOINT LeftLeg\n"
         "\t{\n"
         "\t\tOFFSET 2 -8 0\n"
         "\t\tCHANNELS 3 Xrotation Yrotation Zrotation\n"
         "\t\tEnd Site\n"
         "\t\t{\n"
         "\t\t\tOFFSET 0 -6 0.125\n"
         "\t\t}\n"
         "\t}\n"
         "}\n"
         "MOTION\n"
         "Frames: 3\n"
         "Frame Time: 0.0416667\n"
         "1 51 -20 10 0 -20 1 2 3 -4 5 6 7 8 9\n"
         "2 52 -19 15 0.5 -25 2 3 4 -5 6 7 8 -9 10\n" +
         LastRow();
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  for (; at != text.npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

Character ReadWell(std::string_view text) {
  Result<Character> read = ReadBvh(text, "motions/test.bvh");
  if (read.ok()) {
    ExpectSound(read.value());
    return read.value();
  }
  ADD_FAILURE() << read.error().ToString();
  return {};
}

std::string Warnings(const Character& character) {
  std::string all;
  for (const Warning& warning : character.warnings)
    all += warning.place + ": " + warning.message + "\n";
  return all;
}

namespace {

void ExpectNear(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance,
                const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  double worst = 0.0;
  for (size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, (a[i] - b[i]).cwiseAbs().maxCoeff());
  EXPECT_LE(worst, tolerance) << what;
}

void ExpectSameBone(const Bone& a, const Bone& b, double tolerance) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.parent, b.parent) << a.name;
  EXPECT_EQ(a.rotation_order, b.rotation_order) << a.name;
  ExpectNear({a.rest.p}, {b.rest.p}, tolerance, a.name);
  ASSERT_EQ(a.end_site.has_value(), b.end_site.has_value()) << a.name;
  if (a.end_site) ExpectNear({*a.end_site}, {*b.end_site}, tolerance, a.name);
}

void ExpectSameTrack(const BoneTrack& a, const BoneTrack& b, double tolerance,
                     const std::string& name) {
  ExpectNear(a.angles, b.angles, tolerance, name);
  ExpectNear(a.translations, b.translations, tolerance, name);
  ASSERT_EQ(a.rotations.size(), b.rotations.size()) << name;
  for (size_t i = 0; i < a.rotations.size(); ++i)
    ASSERT_LE(a.rotations[i].angularDistance(b.rotations[i]), 4.0 * tolerance + 1e-7) << name;
}

void ExpectSoundTrack(const BoneTrack& track, int num_frames) {
  const auto all_or_none = [&](size_t n) { return n == 0 || n == static_cast<size_t>(num_frames); };
  ASSERT_TRUE(all_or_none(track.rotations.size()));
  ASSERT_EQ(track.angles.size(), track.rotations.size());
  ASSERT_TRUE(all_or_none(track.translations.size()));
  for (const auto& q : track.rotations) ASSERT_NEAR(q.norm(), 1.0, 1e-12);
  for (const Vec3& p : track.translations) ASSERT_TRUE(p.allFinite());
  for (const Vec3& angles : track.angles) ASSERT_TRUE(angles.allFinite());
}

}  // namespace

void ExpectSame(const Character& a, const Character& b, double tolerance) {
  ASSERT_EQ(a.bones.size(), b.bones.size());
  for (size_t i = 0; i < a.bones.size(); ++i) ExpectSameBone(a.bones[i], b.bones[i], tolerance);
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (size_t c = 0; c < a.clips.size(); ++c) {
    EXPECT_EQ(a.clips[c].num_frames, b.clips[c].num_frames);
    EXPECT_EQ(a.clips[c].seconds_per_frame, b.clips[c].seconds_per_frame);
    for (size_t i = 0; i < a.bones.size(); ++i)
      ExpectSameTrack(a.clips[c].tracks[i], b.clips[c].tracks[i], tolerance, a.bones[i].name);
  }
}

void ExpectSound(const Character& character) {
  ASSERT_EQ(character.clips.size(), 1u);
  const Clip& clip = character.clips[0];
  ASSERT_TRUE(std::isfinite(clip.seconds_per_frame) && clip.seconds_per_frame > 0.0);
  ASSERT_GE(clip.num_frames, 1);
  ASSERT_EQ(clip.tracks.size(), character.bones.size());
  for (size_t i = 0; i < character.bones.size(); ++i) {
    const Bone& bone = character.bones[i];
    ASSERT_FALSE(bone.name.empty());
    ASSERT_LT(bone.parent, static_cast<int>(i));
    ASSERT_EQ(bone.parent < 0, i == 0);
    ASSERT_TRUE(bone.rest.p.allFinite());
    ASSERT_TRUE(!bone.end_site || bone.end_site->allFinite());
    ExpectSoundTrack(clip.tracks[i], clip.num_frames);
  }
}

std::vector<Vec3> Positions(const Character& character, int frame) {
  std::vector<Pose> poses;
  std::vector<Vec3> positions;
  for (size_t i = 0; i < character.bones.size(); ++i) {
    const Bone& bone = character.bones[i];
    const BoneTrack& track = character.clips[0].tracks[i];
    const auto at = static_cast<size_t>(frame);
    Pose pose = bone.rest;
    if (!track.rotations.empty()) pose.R = track.rotations[at].toRotationMatrix();
    if (!track.translations.empty()) pose.p = track.translations[at];
    poses.push_back(bone.parent < 0 ? pose : poses[static_cast<size_t>(bone.parent)] * pose);
    positions.push_back(poses.back().p);
  }
  return positions;
}

}  // namespace hazumi::test
