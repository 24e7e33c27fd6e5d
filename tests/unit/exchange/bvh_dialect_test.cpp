// One motion in the dialects that programs write: all are read as the same, without a warning.

#include <gtest/gtest.h>

#include "engine/base/text.h"
#include "engine/exchange/bvh/bvh_motion.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/exchange/bvh_sample.h"

namespace hazumi::test {
namespace {

TEST(BvhDialect, SmallFileIsReadAsWritten) {
  const Character read = ReadWell(SmallBvh());
  EXPECT_EQ(Warnings(read), "");
  EXPECT_EQ(read.name, "test");
  ASSERT_EQ(read.bones.size(), 4u);
  EXPECT_EQ(read.bones[3].name, "LeftLeg");
  EXPECT_EQ(read.bones[3].parent, 0);
  EXPECT_EQ(read.bones[2].parent, 1);
  EXPECT_EQ(read.bones[0].rotation_order, "ZYX");
  EXPECT_EQ(read.bones[2].rotation_order, "YXZ");
  EXPECT_EQ(read.bones[1].rest.p, Vec3(0, 10, -1.5));
  EXPECT_EQ(*read.bones[3].end_site, Vec3(0, -6, 0.125));
  EXPECT_FALSE(read.bones[1].end_site);
  EXPECT_FALSE(read.up || read.metres_per_unit);
  const Clip& clip = read.clips[0];
  EXPECT_EQ(clip.name, "test");
  EXPECT_EQ(clip.num_frames, 3);
  EXPECT_EQ(clip.seconds_per_frame, 1.0 / 24.0);
  EXPECT_EQ(clip.tracks[0].translations[1], Vec3(2, 52, -19));
  EXPECT_TRUE(clip.tracks[1].translations.empty());
  EXPECT_NEAR(clip.tracks[2].angles[1][2], 7 * kDegree, 1e-15);
  EXPECT_NEAR(clip.tracks[3].angles[2][2], -3 * kDegree, 1e-15);
}

TEST(BvhDialect, SameWhateverTheSpelling) {
  const std::string plain = SmallBvh();
  const Character expected = ReadWell(plain);
  std::string upper = plain, lower = plain;
  for (const char* word : {"OFFSET", "CHANNELS", "JOINT", "ROOT", "HIERARCHY", "MOTION"})
    lower = Replaced(lower, word, LowerCase(word));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"rotation", "ROTATION"},
                                                        {"position", "Position"},
                                                        {"End Site", "END SITE"},
                                                        {"Frame Time", "FRAME TIME"},
                                                        {"Frames", "frames"}}) {
    upper = Replaced(upper, from, to);
  }
  const std::vector<std::string> dialects = {
      upper,
      lower,
      "\xef\xbb\xbf" + plain,
      Replaced(plain, "\n", "\r\n"),
      Replaced(plain, "\n", "\r"),
      "\xef\xbb\xbf" + Replaced(plain, "\n", "\r\n") + "\r\n\r\n \t\r\n",
      plain.substr(0, plain.size() - 1),
      plain + "\n\n  \n\x1a",
      Replaced(plain, "\n", " \t \n"),
      Replaced(plain, "\n", "\n\n"),
      Replaced(plain, "\t", "    "),
      Replaced(plain, " ", "\t"),
      Replaced(Replaced(plain, "Frames: ", "Frames:\t"), "Frame Time: ", "Frame Time :"),
      Replaced(plain, "\n\t\t{", " {"),
      Replaced(plain, "End Site", "End Site toe tip"),
      Replaced(plain, "End Site", "End Effector01"),
      Replaced(plain, " 52 -19 15 ", " +5.2e1 -1.9E+01 015. "),
      Replaced(plain, "0.5 ", ".5 "),
      Replaced(plain, "0.0416667", "4.16667e-2"),
      Replaced(plain, "Frames: 3\nFrame Time: 0.0416667", "Frame Time: 0.0416667\nFrames: 3"),
      Replaced(plain, "-19 ", "-19                                                        "),
  };
  for (size_t i = 0; i < dialects.size(); ++i) {
    SCOPED_TRACE("dialect " + std::to_string(i));
    const Character read = ReadWell(dialects[i]);
    EXPECT_EQ(Warnings(read), "");
    ExpectSame(read, expected, 1e-15);
  }
}

TEST(BvhDialect, NamesKeepTheirSpaces) {
  const Character read = ReadWell(Replaced(SmallBvh(), "JOINT LeftLeg", "JOINT  Left  Leg: 足 "));
  EXPECT_EQ(read.bones[3].name, "Left  Leg: 足");
  EXPECT_EQ(Warnings(read), "");
}

// Rz(90) Rx(90) takes y to z: z first turns the frame, x about the turned axis.
TEST(BvhDialect, ChannelsTurnOneAboutTheAxesOfTheOther) {
  std::string text = Replaced(SmallBvh(), "Zrotation Yrotation Xrotation\n\tJOINT Spine",
                              "Zrotation Xrotation Yrotation\n\tJOINT Spine");
  text = Replaced(text, LastRow(), "0 0 0 90 90 0 0 0 0 0 0 0 0 0 0\n");
  const Character read = ReadWell(text);
  EXPECT_LT((Positions(read, 2)[1] - Vec3(-1.5, 0, 10)).norm(), 1e-12);
}

TEST(BvhDialect, PositionsMayComeAfterRotationsAndBetweenThem) {
  const std::string head = "CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation";
  std::string text = Replaced(
      SmallBvh(), head, "CHANNELS 6 Zrotation Zposition Yrotation Xposition Xrotation Yposition");
  text = Replaced(text, "1 51 -20 10 0 -20 ", "10 -20 0 1 -20 51 ");
  text = Replaced(text, "2 52 -19 15 0.5 -25 ", "15 -19 0.5 2 -25 52 ");
  text = Replaced(text, "2.5 53 -18 20 0.25 -30 ", "20 -18 0.25 2.5 -30 53 ");
  ExpectSame(ReadWell(text), ReadWell(SmallBvh()), 0.0);
}

// As in Blender: they take the place of OFFSET, of the root and of any other joint.
TEST(BvhDialect, PositionsStandForTheOffset) {
  std::string text =
      Replaced(SmallBvh(), "CHANNELS 3 Xrotation Yrotation Zrotation",
               "CHANNELS 6 Xposition Yposition Zposition Xrotation Yrotation Zrotation");
  text = Replaced(text, " 7 8 9\n", " 20 30 40 7 8 9\n");
  text = Replaced(text, " 8 -9 10\n", " 20 30 40 8 -9 10\n");
  text = Replaced(text, LastRow(), "1 2 3 0 0 0 0 0 0 0 0 0 20 30 40 0 0 0\n");
  const Character read = ReadWell(text);
  EXPECT_EQ(read.bones[3].rest.p, Vec3(2, -8, 0));
  EXPECT_EQ(Positions(read, 2)[0], Vec3(1, 2, 3));
  EXPECT_EQ(Positions(read, 2)[3], Vec3(21, 32, 43));
}

TEST(BvhDialect, FewerChannelsAreThoseThatMove) {
  std::string text = Replaced(SmallBvh(), "3 Xrotation Yrotation Zrotation", "1 Yrotation");
  text = Replaced(text, "CHANNELS 3 Yrotation Xrotation Zrotation", "CHANNELS 0");
  text = Replaced(text, "1 51 -20 10 0 -20 1 2 3 -4 5 6 7 8 9", "1 51 -20 10 0 -20 1 2 3 8");
  text = Replaced(text, "2 52 -19 15 0.5 -25 2 3 4 -5 6 7 8 -9 10", "2 5 -1 15 0 -25 2 3 4 -9");
  text = Replaced(text, LastRow(), "1 51 -20 10 0 -20 1 2 3 90\n");
  const Character read = ReadWell(text);
  EXPECT_EQ(Warnings(read), "");
  EXPECT_EQ(read.bones[3].rotation_order, "Y");
  EXPECT_EQ(read.bones[2].rotation_order, "");
  EXPECT_TRUE(read.clips[0].tracks[2].rotations.empty());
  const Vec3 turned = read.clips[0].tracks[3].rotations[2] * Vec3::UnitZ();
  EXPECT_LT((turned - Vec3::UnitX()).norm(), 1e-12);
}

TEST(BvhFrameTime, IsTheRateThatWasMeant) {
  const auto seconds = [](const char* written) {
    const SnappedFrameTime time = SnapFrameTime(std::stod(written), written);
    EXPECT_FALSE(time.was_coarse) << written;
    return time.seconds;
  };
  EXPECT_EQ(seconds("0.0416667"), 1.0 / 24.0);
  EXPECT_EQ(seconds("0.041667"), 1.0 / 24.0);
  EXPECT_EQ(seconds(".0083333"), 1.0 / 120.0);
  EXPECT_EQ(seconds("0.008333"), 1.0 / 120.0);
  EXPECT_EQ(seconds("0.033333"), 1.0 / 30.0);
  EXPECT_EQ(seconds("0.0166667"), 1.0 / 60.0);
  EXPECT_EQ(seconds("0.04"), 1.0 / 25.0);
  EXPECT_EQ(seconds("0.008"), 1.0 / 125.0);
  EXPECT_EQ(seconds("0.008342"), 1.001 / 120.0);
  EXPECT_EQ(seconds("0.0333667"), 1.001 / 30.0);
  EXPECT_EQ(seconds("1"), 1.0);
  EXPECT_EQ(seconds("0.0123456"), 1.0 / 81.0);
  EXPECT_EQ(seconds("0.034"), 0.034) << "neither rounded nor cut from a usual rate";
  EXPECT_EQ(seconds("0.4"), 0.4);
}

TEST(BvhFrameTime, OfFewDigitsIsAGuessThatIsSaid) {
  for (const auto& [written, fps] :
       std::vector<std::pair<std::string, double>>{{"0.033", 30.0},
                                                   {"0.0333", 30.0},
                                                   {"0.017", 60.0},
                                                   {"0.016", 60.0},
                                                   {"0.042", 24.0},
                                                   {"0.0083", 120.0}}) {
    const SnappedFrameTime time = SnapFrameTime(std::stod(written), written);
    EXPECT_EQ(time.seconds, 1.0 / fps) << written;
    EXPECT_TRUE(time.was_coarse) << written;
  }
  const Character read = ReadWell(Replaced(SmallBvh(), "0.0416667", "0.033"));
  EXPECT_EQ(Warnings(read), "line 32: Frame Time 0.033 was taken as 1/30 s\n");
}

}  // namespace
}  // namespace hazumi::test
