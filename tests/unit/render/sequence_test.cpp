#include "render/pipeline/sequence.h"

#include <gtest/gtest.h>

#include "demo_scene.h"
#include "png_file.h"
#include "temp_folder.h"

namespace hazumi::render {
namespace {

constexpr int kFrames = 5;

std::string NameOf(int frame) { return std::to_string(frame) + ".png"; }

Sequence SequenceInto(const std::filesystem::path& folder) {
  Sequence sequence;
  sequence.frame_count = kFrames;
  sequence.scene = MakeGhostScene;
  sequence.path = [folder](int frame) { return folder / NameOf(frame); };
  sequence.metadata = [](int frame) {
    return std::vector<PngText>{{"Frame", std::to_string(frame)}};
  };
  return sequence;
}

SequenceOptions SmallPictures(int threads) {
  return {.width = 160, .height = 120, .renderer = {}, .threads = threads};
}

std::vector<std::string> FilesOfARun(int threads) {
  const TempFolder folder;
  EXPECT_EQ(RenderSequence(SmallPictures(threads), SequenceInto(folder.path())).value(), kFrames);
  EXPECT_EQ(folder.file_count(), kFrames);
  std::vector<std::string> files;
  for (int frame = 0; frame < kFrames; ++frame)
    files.push_back(BytesOf(folder.path() / NameOf(frame)));
  return files;
}

TEST(RenderSequence, GivesTheSameBytesEveryRunAndForAnyThreads) {
  const auto files = FilesOfARun(2);
  EXPECT_GT(files[0].size(), 1000u);
  EXPECT_NE(files[0], files[1]);
  EXPECT_EQ(files, FilesOfARun(2));
  EXPECT_EQ(files, FilesOfARun(1));
}

TEST(RenderSequence, StopsAtAFileThatCannotBeWritten) {
  for (const int threads : {1, 2}) {
    const TempFolder folder;
    Sequence sequence = SequenceInto(folder.path());
    sequence.path = [&](int frame) {
      return frame < 2 ? folder.path() / NameOf(frame) : folder.path() / "no" / "x.png";
    };
    const Result<int> written = RenderSequence(SmallPictures(threads), sequence);
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
    EXPECT_EQ(folder.file_count(), 2);
  }
}

TEST(RenderSequence, CancelLeavesWholeFilesOnly) {
  for (const int threads : {1, 2}) {
    const TempFolder folder;
    std::atomic<bool> cancel = false;
    Sequence sequence = SequenceInto(folder.path());
    sequence.frame_count = 1000;
    sequence.progress = [&](int written) { cancel = written >= 2; };
    sequence.cancel = &cancel;
    const int written = RenderSequence(SmallPictures(threads), sequence).value();
    EXPECT_GE(written, 2);
    EXPECT_LE(written, 6);
    EXPECT_EQ(folder.file_count(), written);
    for (int i = 0; i < written; ++i) EXPECT_TRUE(ReadPng(folder.path() / NameOf(i)).ok());
  }
}

TEST(RenderSequence, ReportsProgressInOrder) {
  const TempFolder folder;
  std::vector<int> reports;
  Sequence sequence = SequenceInto(folder.path());
  sequence.progress = [&](int written) { reports.push_back(written); };
  ASSERT_TRUE(RenderSequence(SmallPictures(2), sequence).ok());
  EXPECT_EQ(reports, (std::vector<int>{1, 2, 3, 4, 5}));
}

TEST(RenderSequence, RefusesAPictureOfNoSize) {
  const TempFolder folder;
  SequenceOptions options = SmallPictures(1);
  options.width = 0;
  EXPECT_FALSE(RenderSequence(options, SequenceInto(folder.path())).ok());
  EXPECT_EQ(folder.file_count(), 0);
}

}  // namespace
}  // namespace hazumi::render
