// Every way in which a file can be wrong: an error that names the line and what to do, or a repair
// that is said.

#include <gtest/gtest.h>

#include "tests/unit/exchange/bvh_sample.h"

namespace hazumi::test {
namespace {

// How SmallBvh is broken, and what must be said of it.
struct Broken {
  std::string text;
  std::string place;
  std::string says;  // is in the message
};

Broken With(const std::string& from, const std::string& to, const std::string& place,
            const std::string& says) {
  return {Replaced(SmallBvh(), from, to), place, says};
}

std::string Chain(int num_joints) {
  std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
  for (int i = 1; i < num_joints; ++i)
    text += "JOINT b" + std::to_string(i) + "\n{\nOFFSET 0 1 0\n";
  for (int i = 0; i < num_joints; ++i) text += "}\n";
  return text + "MOTION\nFrames: 1\nFrame Time: 0.04\n0\n";
}

std::string Fan(int num_joints) {
  std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
  for (int i = 1; i < num_joints; ++i)
    text += "JOINT b\n{\nOFFSET 0 1 0\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n";
  return text + "}\nMOTION\nFrames: 1\nFrame Time: 0.04\n0\n";
}

std::vector<Broken> Hierarchies() {
  const std::string second = "}\nROOT Other\n{\nOFFSET 0 0 0\n}\nMOTION";
  return {
      {"", "line 1", "the file is empty"},
      {"\xef\xbb\xbf", "line 1", "the file is empty"},
      {"solid cube\n", "line 1", "begins with \"solid\", a BVH file begins with HIERARCHY"},
      {std::string("Kaydara FBX Binary  \0", 21), "line 1", "binary"},
      {SmallBvh() + std::string(1, '\0'), "line 36", "binary"},
      {"\xff\xfeH", "line 1", "UTF-16"},
      With("}\nMOTION", second, "line 30", "a second root \"Other\" after \"Hips\""),
      With("ROOT Hips", "JOINT Hips", "line 2", "where ROOT should be"),
      With("ROOT Hips", "ROOT", "line 2", "has no name"),
      With("}\nMOTION", "}\n}\nMOTION", "line 30", "\"}\" more than"),
      With("}\nMOTION", "MOTION", "line 29", "not closed, the last that of \"Hips\" in line 2"),
      With("LeftLeg\n\t{\n", "LeftLeg\n", "line 21", "\"{\" is missing after joint \"LeftLeg\""),
      With("OFFSET 0 8 0", "OFFSET 0 eight 0", "line 12", "\"eight\" is not a finite number"),
      With("OFFSET 0 8 0", "OFFSET 0 nan 0", "line 12", "\"nan\" is not a finite number"),
      With("OFFSET 0 8 0", "OFFSET 0 1e9 0", "line 12", "out of range"),
      With("OFFSET 0 8 0", "OFFSET 0,5 8 0", "line 12", "decimal point"),
      With("OFFSET 0 8 0", "OFFSET 0 8", "line 13", "OFFSET of \"Head\": \"CHANNELS\""),
      With("OFFSET 0 8 0", "OFFSET 0 8 0\nOFFSET 0 8 0", "line 13", "two OFFSETs"),
      With("CHANNELS 3 Y", "CHANNELS 0\nCHANNELS 3 Y", "line 14", "two lines of CHANNELS"),
      With("CHANNELS 3 Y", "CHANNELS Y", "line 13", "not with their number"),
      With("3 Yrotation", "3 Wrotation", "line 13", "unknown channel \"Wrotation\" of \"Head\""),
      With("3 Yrotation", "3 Xrotation", "line 13", "\"Head\" has Xrotation twice"),
      With("OFFSET 0 4 0", "OFFSET 0 4 0\nCHANNELS 1 Xrotation", "line 17",
           "End Site has channels"),
      With("OFFSET 0 4 0", "JOINT a\n{\n}", "line 16", "inside an End Site"),
      With("OFFSET 0 4 0", "End Site\n{\n}", "line 16", "End Site is inside an End Site"),
      With("OFFSET 0 8 0", "OFSET 0 8 0", "line 12", "\"OFSET\" in \"Head\" is none of"),
      With("MOTION", "MOTIONS", "line 30", "\"MOTIONS\" stands where MOTION should be"),
      {"HIERARCHY\nMOTION\n", "line 2", "MOTION comes before any ROOT"},
      {"HIERARCHY\n", "line 2", "no ROOT"},
      {SmallBvh().substr(0, 60), "line 5", "the file ends inside \"Hips\" of line 2"},
      {SmallBvh().substr(0, 40), "line 4", "the file ends inside \"Hips\" of line 2"},
      {Chain(257), "line 771", "more than 256 joints inside one another"},
      {Chain(20000), "line 771", "more than 256 joints inside one another"},
      {Fan(4097), "line 32766", "more than 4096 joints"},
  };
}

std::vector<Broken> Motions() {
  const std::string start = SmallBvh().substr(0, SmallBvh().find("MOTION"));
  return {
      {start, "line 30", "the file has no MOTION"},
      {start + "MOTION\n", "line 30", "no Frame Time"},
      {start + "MOTION\nFrames: 0\nFrame Time: 0.04\n", "line 33", "MOTION has no frame"},
      {start + "MOTION\nFrames: 1\nFrame Time: 0.04\n1 2 3", "line 33", "MOTION has no frame"},
      With("0.0416667", "nan", "line 32", "Frame Time: \"nan\" is not a finite number"),
      With("0.0416667", "inf", "line 32", "Frame Time: \"inf\""),
      With("0.0416667", "0", "line 32",
           "Frame Time \"0\" is no time between frames; write seconds"),
      With("0.0416667", "-0.01", "line 32", "Frame Time \"-0.01\" is no time"),
      With("0.0416667", "1e-300", "line 32", "is no time"),
      With("0.0416667", "1e300", "line 32", "is no time"),
      With("0.0416667", "0,0416667", "line 32", "has a comma"),
      With("0.0416667", "", "line 32", "a number is missing"),
      With("0.0416667", "0.04 s", "line 32", "\"0.04 s\" is not a finite number"),
      With("Frame Time: 0.0416667\n", "", "line 31", "no Frame Time; add a line such as"),
      With(" 52 -19", " nan -19", "line 34", "value 2 (\"Hips\" Yposition): \"nan\""),
      With(" 52 -19", " inf -19", "line 34", "\"inf\" is not a finite number"),
      With(" 52 -19", " -1.#IND -19", "line 34", "\"-1.#IND\" is not a finite number"),
      With(" 52 -19", " 1e308 -19", "line 34", "\"1e308\" is out of range (largest: 1e+08)"),
      With(" 52 -19", " 1e999 -19", "line 34", "\"1e999\" is not a finite number"),
      With(" 0.5 -25", " 2e7 -25", "line 34", "value 5 (\"Hips\" Yrotation): \"2e7\" is out of"),
      With(" 52 -19", " 52,5 -19", "line 34", "\"52,5\" has a comma"),
      With(" 52 -19", " 0x34 -19", "line 34", "\"0x34\" is not a finite number"),
      With(" 52 -19", " hello 52 -19", "line 34", "\"hello\" is not a finite number"),
      With(" 52 -19", " -19", "line 34", "has 14 values where the channels need 15"),
  };
}

void ExpectError(const Broken& broken) {
  const Result<Character> read = ReadBvh(broken.text, "motions/walk.bvh");
  ASSERT_FALSE(read.ok()) << broken.says;
  EXPECT_EQ(read.error().file, "motions/walk.bvh");
  EXPECT_EQ(read.error().place, broken.place) << read.error().ToString();
  EXPECT_NE(read.error().message.find(broken.says), std::string::npos)
      << read.error().ToString() << "\nexpected: " << broken.says;
  EXPECT_NE(read.error().message.find_first_of(",;:"), std::string::npos)
      << "no remedy: " << read.error().ToString();
}

TEST(MalformedBvh, BrokenHierarchyIsAnErrorWithLineAndRemedy) {
  for (const Broken& broken : Hierarchies()) ExpectError(broken);
}

TEST(MalformedBvh, BrokenMotionIsAnErrorWithLineAndRemedy) {
  for (const Broken& broken : Motions()) ExpectError(broken);
}

TEST(MalformedBvh, SeveralRootsAreNoSyntaxError) {
  const std::string text = Replaced(SmallBvh(), "}\nMOTION", "}\nROOT b\n{\n}\nMOTION");
  EXPECT_EQ(ReadBvh(text, "").error().code, ErrorCode::kSemantics);
}

// Whatever is said of the motion stays as it is, and the repair is said.
std::vector<Broken> Repaired() {
  return {
      With("Frames: 3", "Frames: 1000000000", "line 31",
           "Frames says \"1000000000\", the file has 3: 3 were read"),
      With("Frames: 3", "Frames: 1", "line 31", "Frames says \"1\", the file has 3"),
      With("Frames: 3", "Frames: 0", "line 31", "Frames says \"0\", the file has 3"),
      With("Frames: 3", "Frames: -5", "line 31", "Frames says \"-5\", the file has 3"),
      With("Frames: 3", "Frames: many", "line 31", "Frames says \"many\", the file has 3"),
      With("Frames: 3\n", "", "line 30", "no number of Frames is given, the file has 3"),
      With(" 8 -9 10\n", " 8 -9 10 11 12\n", "line 34",
           "1 row has more values than the 15 channels (here 17)"),
      With(" 8 -9 10\n", " 8 -9 10 1e300\n", "line 34", "more values than the 15 channels"),
      With("-19 15", "-19\n15", "line 33", "broken over several lines"),
      With("CHANNELS 3 Y", "CHANNELS 4 Y", "line 13",
           "CHANNELS of \"Head\" says 4 and names 3: the names were taken"),
      With("CHANNELS 3 Y", "CHANNELS 2147483647 Y", "line 13", "says 2147483647 and names 3"),
      With("\t\t\t\tOFFSET 0 4 0\n\t\t\t}\n",
           "\t\t\t\tOFFSET 0 4 0\n\t\t\t}\nEnd Site\n{\nOFFSET 1 1 1\n}\n", "line 18",
           "a further End Site of \"Head\" was left out"),
  };
}

TEST(MalformedBvh, WhatCanBeRepairedIsAndIsSaid) {
  const Character whole = ReadWell(SmallBvh());
  for (const Broken& broken : Repaired()) {
    SCOPED_TRACE(broken.says);
    const Character read = ReadWell(broken.text);
    ExpectSame(read, whole, 0.0);
    ASSERT_EQ(read.warnings.size(), 1u) << Warnings(read);
    EXPECT_EQ(read.warnings[0].place, broken.place) << Warnings(read);
    EXPECT_NE(read.warnings[0].message.find(broken.says), std::string::npos) << Warnings(read);
  }
}

TEST(MalformedBvh, LastRowThatWasCutIsLeftOutAndSaid) {
  for (const char* end : {"2.5 53", "2.5 53\n", "2.5 53 -", "2.5 53 -1e", "2.5"}) {
    const Character read = ReadWell(Replaced(SmallBvh(), LastRow(), end));
    EXPECT_EQ(read.clips[0].num_frames, 2);
    EXPECT_NE(Warnings(read).find("line 35: the last row has "), std::string::npos);
    EXPECT_NE(Warnings(read).find("the file was cut here"), std::string::npos);
    EXPECT_NE(Warnings(read).find("Frames says \"3\", the file has 2"), std::string::npos);
  }
}

TEST(MalformedBvh, SameNamesAreToldApart) {
  std::string text = Replaced(SmallBvh(), "JOINT LeftLeg", "JOINT Hips");
  text = Replaced(text, "JOINT Spine", "JOINT Hips_2");
  const Character read = ReadWell(text);
  EXPECT_EQ(read.bones[0].name, "Hips");
  EXPECT_EQ(read.bones[1].name, "Hips_2");
  EXPECT_EQ(read.bones[3].name, "Hips_3");
  EXPECT_EQ(Warnings(read), "line 20: a second joint \"Hips\" was renamed \"Hips_3\"\n");
}

TEST(MalformedBvh, ManySameNamesTakeNoTime) {
  const Character read = ReadWell(Fan(4096));
  EXPECT_EQ(read.bones.back().name, "b_4095");
}

TEST(MalformedBvh, BonesWithoutAnEndAreNamed) {
  const std::string text =
      Replaced(SmallBvh(), "End Site\n\t\t\t{\n\t\t\t\tOFFSET 0 4 0\n\t\t\t}\n", "");
  const Character read = ReadWell(text);
  EXPECT_FALSE(read.bones[2].end_site);
  EXPECT_EQ(Warnings(read), "line 10: no End Site says how long these bones are: \"Head\"\n");
}

TEST(MalformedBvh, MissingOffsetIsSaid) {
  const Character read = ReadWell(Replaced(SmallBvh(), "\t\t\tOFFSET 0 8 0\n", ""));
  EXPECT_EQ(read.bones[2].rest.p, Vec3(0, 0, 0));
  EXPECT_EQ(Warnings(read), "line 10: \"Head\" has no OFFSET and is put on its parent\n");
}

// Missing positions are 0, as in Blender, and not those of OFFSET.
TEST(MalformedBvh, PartOfThePositionsIsSaid) {
  std::string text =
      Replaced(SmallBvh(), "6 Xposition Yposition Zposition", "5 Xposition Zposition");
  text = Replaced(Replaced(text, "1 51 -20", "1 -20"), "2 52 -19", "2 -19");
  const Character read = ReadWell(Replaced(text, "2.5 53 -18", "2.5 -18"));
  EXPECT_EQ(read.clips[0].tracks[0].translations[0], Vec3(1, 0, -20));
  EXPECT_NE(Warnings(read).find("line 2: \"Hips\" has no Yposition"), std::string::npos);
}

TEST(MalformedBvh, NamesThatAreNotUtf8AreReplacedAndSaid) {
  const Character read = ReadWell(Replaced(SmallBvh(), "JOINT Head",
                                           "JOINT H\xe9"
                                           "ad"));
  EXPECT_EQ(read.bones[2].name,
            "H\uFFFD"
            "ad");
  EXPECT_EQ(Warnings(read),
            "line 10: a name is not UTF-8 and was read as \"H\uFFFD"
            "ad\"\n");
}

}  // namespace
}  // namespace hazumi::test
