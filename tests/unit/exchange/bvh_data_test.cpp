// Real files and broken ones beside the repository.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "engine/exchange/bvh/bvh_file.h"
#include "engine/spatial/degrees.h"
#include "tests/support/data_folder.h"
#include "tests/unit/exchange/bvh_sample.h"

namespace hazumi::test {
namespace {

namespace fs = std::filesystem;

std::string FileText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> FilesIn(const std::string& folder, const std::string& prefix = "") {
  std::vector<fs::path> files;
  for (const fs::path& path : DataFiles(folder)) {
    const std::string name = path.filename().string();
    if (name.ends_with(".bvh") && name.starts_with(prefix)) files.push_back(path);
  }
  return files;
}

const std::vector<const char*> kFolders = {"jump", "throw", "other"};

std::vector<fs::path> Clips() {
  std::vector<fs::path> all;
  for (const char* folder : kFolders) {
    for (const fs::path& path : FilesIn(folder)) all.push_back(path);
  }
  return all;
}

TEST(BvhData, EveryClipIsReadWithoutAWarning) {
  for (const char* folder : kFolders) HAZUMI_NEED_DATA(folder);
  for (const fs::path& path : Clips()) {
    SCOPED_TRACE(path.filename());
    EXPECT_EQ(Warnings(ReadWell(FileText(path))), "");
  }
}

TEST(BvhData, EveryClipIsTheSameAfterWritingAndReading) {
  for (const char* folder : kFolders) HAZUMI_NEED_DATA(folder);
  for (const fs::path& path : Clips()) {
    SCOPED_TRACE(path.filename());
    const Character read = ReadWell(FileText(path));
    const std::string written = BvhText(read, read.clips[0]);
    const Character back = ReadWell(written);
    EXPECT_EQ(Warnings(back), "");
    ExpectSame(back, read, 0.51e-6);
    for (size_t i = 0; i < read.bones.size(); ++i) {
      const BoneTrack &a = read.clips[0].tracks[i], &b = back.clips[0].tracks[i];
      for (size_t f = 0; f < a.angles.size(); ++f)
        ASSERT_LT((a.angles[f] - b.angles[f]).cwiseAbs().maxCoeff(), 1e-6 * kDegree);
    }
    EXPECT_EQ(BvhText(back, back.clips[0]), written);
  }
}

// As if it came from a program that keeps quaternions only.
TEST(BvhData, EveryClipKeepsItsPosesWithoutItsAngles) {
  for (const char* folder : kFolders) HAZUMI_NEED_DATA(folder);
  for (const fs::path& path : Clips()) {
    SCOPED_TRACE(path.filename());
    Character bare = ReadWell(FileText(path));
    for (Bone& bone : bare.bones) bone.rotation_order.clear();
    for (BoneTrack& track : bare.clips[0].tracks) track.angles.clear();
    const Character back = ReadWell(BvhText(bare, bare.clips[0]));
    for (int frame = 0; frame < bare.clips[0].num_frames; ++frame) {
      const auto a = Positions(bare, frame), b = Positions(back, frame);
      for (size_t i = 0; i < a.size(); ++i) ASSERT_LT((a[i] - b[i]).norm(), 2e-5) << frame;
    }
  }
}

TEST(BvhData, DialectsAreAllTheSame) {
  const std::string first = "malformed/bvh/ok_20frames.bvh";
  HAZUMI_NEED_DATA(first);
  const Character expected = ReadWell(FileText(DataPath(first)));
  EXPECT_EQ(expected.clips[0].num_frames, 20);
  EXPECT_EQ(expected.clips[0].seconds_per_frame, 1.0 / 120.0);
  for (const fs::path& path : FilesIn("malformed/bvh", "ok_")) {
    SCOPED_TRACE(path.filename());
    const Character read = ReadWell(FileText(path));
    EXPECT_EQ(Warnings(read), "");
    ExpectSame(read, expected, 1e-12);
  }
}

// What the error or a warning of each must say.
const std::map<std::string, std::string>& Promised() {
  static const std::map<std::string, std::string> promised = {
      {"bad_binary", "line 1: the file is binary"},
      {"bad_channel_count_huge", "says 2147483647 and names 3"},
      {"bad_channel_count_lies", "says 4 and names 3"},
      {"bad_comma_decimals", "line 188: value 1 (\"Hips\" Xposition): \"9,4455\" has a comma"},
      {"bad_duplicate_joint_names", "a second joint \"LeftLeg\" was renamed \"LeftLeg_2\""},
      {"bad_empty", "the file is empty"},
      {"bad_frame_time_nan", "line 187: Frame Time: \"nan\" is not a finite number"},
      {"bad_frame_time_negative", "line 187: Frame Time \"-0.01\" is no time"},
      {"bad_frame_time_zero", "line 187: Frame Time \"0\" is no time"},
      {"bad_frames_count_negative", "Frames says \"-5\", the file has 20"},
      {"bad_frames_count_too_big", "Frames says \"1000000000\", the file has 20"},
      {"bad_frames_count_too_small", "Frames says \"3\", the file has 20"},
      {"bad_frames_zero", "MOTION has no frame"},
      {"bad_huge_value", "line 193: value 1 (\"Hips\" Xposition): \"1e308\" is out of range"},
      {"bad_nan_inf_values", "line 193: value 1 (\"Hips\" Xposition): \"nan\""},
      {"bad_no_end_site", "no End Site says how long these bones are: \"LeftToeBase\""},
      {"bad_no_motion", "the file has no MOTION"},
      {"bad_row_long", "line 197: 1 row has more values than the 96 channels (here 99)"},
      {"bad_row_short", "line 197: the row has 93 values where the channels need 96"},
      {"bad_text_in_motion", "line 193: value 1 (\"Hips\" Xposition): \"hello\" is not"},
      {"bad_truncated_in_hierarchy", "the file ends inside the End Site of \"LeftToeBase\""},
      {"bad_truncated_in_motion", "line 207: the last row has 45 values"},
      {"bad_two_roots", "line 185: a second root \"Hips\""},
      {"bad_unbalanced_brace_extra", "line 185: a \"}\" more than"},
      {"bad_unbalanced_brace_missing", "MOTION begins, but 1 \"{\" are not closed"},
      {"bad_unknown_channel", "line 5: unknown channel \"Wrotation\""},
  };
  return promised;
}

TEST(BvhData, EveryBrokenFileSaysWhatItsNamePromises) {
  HAZUMI_NEED_DATA("malformed/bvh");
  for (const fs::path& path : FilesIn("malformed/bvh", "bad_")) {
    const Result<Character> read = ReadBvh(FileText(path), path.filename().string());
    if (read.ok()) ExpectSound(read.value());
    const std::string said = read.ok() ? Warnings(read.value()) : read.error().ToString();
    const auto promised = Promised().find(path.stem().string());
    ASSERT_NE(promised, Promised().end()) << path << " is new: " << said;
    EXPECT_NE(said.find(promised->second), std::string::npos) << path << ": " << said;
  }
}

}  // namespace
}  // namespace hazumi::test
