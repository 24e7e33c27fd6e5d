#include <gtest/gtest.h>

#include "engine/exchange/bvh/bvh_file.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/exchange/bvh_sample.h"

namespace hazumi::test {
namespace {

constexpr double kRounding = 0.5001e-6;  // of the sixth decimal; angles are rounded in degrees

std::string Written(const Character& character) { return BvhText(character, character.clips[0]); }

void AddBone(Character* character, const std::string& name, int parent) {
  Bone bone;
  bone.name = name;
  bone.parent = parent;
  character->bones.push_back(bone);
}

// The root and one child, with two frames and no motion yet.
Character TwoBones() {
  Character character;
  character.bones.resize(2);
  character.bones[0].name = "root";
  character.bones[1].name = "arm";
  character.bones[1].parent = 0;
  character.bones[1].rest.p = Vec3(0, 1.5, -0.25);
  character.clips.push_back({"clip", 1.0 / 30.0, 2, std::vector<BoneTrack>(2)});
  return character;
}

TEST(BvhText, IsWrittenAsOthersReadIt) {
  Character character = TwoBones();
  character.clips[0].tracks[0].translations = {Vec3(-1e-9, 2, 3), Vec3(4, -6e-7, 6)};
  character.clips[0].tracks[1].rotations = {
      Eigen::Quaterniond::Identity(),
      Eigen::Quaterniond(Eigen::AngleAxisd(30 * kDegree, Vec3::UnitX()))};
  EXPECT_EQ(Written(character),
            "HIERARCHY\n"
            "ROOT root\n"
            "{\n"
            "\tOFFSET 0.000000 0.000000 0.000000\n"
            "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "\tJOINT arm\n"
            "\t{\n"
            "\t\tOFFSET 0.000000 1.500000 -0.250000\n"
            "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "\t\tEnd Site\n"
            "\t\t{\n"
            "\t\t\tOFFSET 0.000000 0.000000 0.000000\n"
            "\t\t}\n"
            "\t}\n"
            "}\n"
            "MOTION\n"
            "Frames: 2\n"
            "Frame Time: 0.03333333333333333\n"
            "0.000000 2.000000 3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n"
            "4.000000 -0.000001 6.000000 0.000000 0.000000 0.000000 0.000000 30.000000 0.000000\n");
}

TEST(BvhText, IsReadBackAsItWas) {
  const Character character = ReadWell(SmallBvh());
  const std::string text = Written(character);
  const Character back = ReadWell(text);
  EXPECT_EQ(Warnings(back), "");
  ExpectSame(back, character, kRounding);
  EXPECT_EQ(Written(back), text);
}

TEST(BvhText, KeepsAnglesBeyondOneTurn) {
  const Character character = ReadWell(Replaced(SmallBvh(), " -25 ", " -1234.5 "));
  const Character back = ReadWell(Written(character));
  EXPECT_NEAR(back.clips[0].tracks[0].angles[1][2], -1234.5 * kDegree, 1e-12);
}

TEST(BvhText, MovedBonesBesideTheRootHaveSixChannels) {
  Character character = TwoBones();
  character.clips[0].tracks[1].translations = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  const Character back = ReadWell(Written(character));
  EXPECT_EQ(back.clips[0].tracks[1].translations, character.clips[0].tracks[1].translations);
  EXPECT_EQ(back.bones[1].rest.p, character.bones[1].rest.p);
}

TEST(BvhText, RootWithoutPositionsStaysAtItsRest) {
  Character character = TwoBones();
  character.bones[0].rest.p = Vec3(0, 90, 1);
  EXPECT_EQ(Positions(ReadWell(Written(character)), 1)[1], Vec3(0, 91.5, 0.75));
}

TEST(BvhText, RestRotationsGoIntoTheFrames) {
  Character character = TwoBones();
  character.bones[0].rest.R =
      Eigen::AngleAxisd(1.0, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const auto before = Positions(character, 1), after = Positions(ReadWell(Written(character)), 1);
  EXPECT_LT((before[1] - after[1]).norm(), 1e-6);
}

TEST(BvhText, RotationsOfUnknownOrderGoOnWithoutAJump) {
  Character character = TwoBones();
  Clip& clip = character.clips[0];
  clip.num_frames = 200;
  for (int i = 0; i < clip.num_frames; ++i) {
    clip.tracks[1].rotations.emplace_back(Eigen::AngleAxisd(0.1 * i, Vec3(1, 2, 3).normalized()));
  }
  const Character back = ReadWell(Written(character));
  const BoneTrack& track = back.clips[0].tracks[1];
  EXPECT_EQ(back.bones[1].rotation_order, "ZXY");
  for (size_t i = 0; i < 200; ++i) {
    ASSERT_LT(track.rotations[i].angularDistance(clip.tracks[1].rotations[i]), 1e-7);
    if (i > 0) {
      ASSERT_LT((track.angles[i] - track.angles[i - 1]).norm(), 0.5) << i;
    }
  }
}

TEST(BvhText, SeveralRootsAreOneTree) {
  Character character = TwoBones();
  character.bones[1].parent = -1;
  character.clips[0].tracks[1].translations = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  const Character back = ReadWell(Written(character));
  ASSERT_EQ(back.bones.size(), 3u);
  EXPECT_EQ(back.bones[0].name, "all_roots");
  EXPECT_EQ(back.bones[2].parent, 0);
  EXPECT_EQ(Positions(back, 1)[2], Vec3(4, 5, 6));
}

// Bones may be listed so that a branch is broken off and taken up again.
TEST(BvhText, WritesBranchByBranchWhateverTheOrderOfBones) {
  Character character = TwoBones();
  AddBone(&character, "leg", 0);
  AddBone(&character, "hand", 1);
  character.clips[0].tracks.resize(4);
  const Character back = ReadWell(Written(character));
  ASSERT_EQ(back.bones.size(), 4u);
  EXPECT_EQ(back.bones[2].name, "hand");
  EXPECT_EQ(back.bones[2].parent, 1);
  EXPECT_EQ(back.bones[3].name, "leg");
  EXPECT_EQ(back.bones[3].parent, 0);
}

TEST(BvhText, BonesWithChildrenKeepTheirEnd) {
  Character character = TwoBones();
  character.bones[0].end_site = Vec3(7, 8, 9);
  EXPECT_EQ(*ReadWell(Written(character)).bones[0].end_site, Vec3(7, 8, 9));
}

TEST(BvhText, NamesFitOnTheirLine) {
  Character character = TwoBones();
  character.bones[1].name = "a{b}\nJOINT c";
  EXPECT_EQ(ReadWell(Written(character)).bones[1].name, "a_b__JOINT c");
}

TEST(BvhText, DeepChainsAreWritten) {
  Character character;
  for (int i = 0; i < 20000; ++i) AddBone(&character, "b" + std::to_string(i), i - 1);
  character.clips.push_back({"clip", 1.0, 1, std::vector<BoneTrack>(20000)});
  const std::string text = Written(character);
  EXPECT_NE(text.find("JOINT b19999"), std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
