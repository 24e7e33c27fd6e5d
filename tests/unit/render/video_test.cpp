#include "render/pipeline/video.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "temp_folder.h"

namespace hazumi::render {
namespace {

bool Has(const std::string& program) {
  return std::system((program + " -version >/dev/null 2>&1").c_str()) == 0;
}

std::string OutputOf(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  return text;
}

Image Grey(int width, int height, int level) {
  Image image(width, height);
  std::fill(image.rgba.begin(), image.rgba.end(), static_cast<std::uint8_t>(level));
  return image;
}

TEST(VideoWriter, WritesEveryPicture) {
  if (!Has("ffmpeg") || !Has("ffprobe")) GTEST_SKIP() << "ffmpeg or ffprobe is not installed";
  TempFolder folder;
  const std::filesystem::path path = folder.path() / "it's a video.mp4";
  auto writer = VideoWriter::Start({path, 64, 48, 30000, 1001});
  ASSERT_TRUE(writer.ok()) << writer.error().ToString();
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(writer.value().Write(Grey(64, 48, 30 * i)).ok());
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(writer.value().Finish().ok());
  const std::string seen = OutputOf(
      "ffprobe -v error -count_frames -show_entries "
      "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames "
      "-of default=noprint_wrappers=1 \"" +
      path.string() + "\"");
  for (const char* wanted : {"codec_name=h264\n", "width=64\n", "height=48\n", "pix_fmt=yuv420p\n",
                             "r_frame_rate=30000/1001\n", "nb_read_frames=7\n"}) {
    EXPECT_NE(seen.find(wanted), std::string::npos) << wanted << "not in:\n" << seen;
  }
}

TEST(VideoWriter, LeavesNothingUnlessFinished) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  TempFolder folder;
  {
    auto writer = VideoWriter::Start({folder.path() / "v.mp4", 64, 48, 30, 1});
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE(writer.value().Write(Grey(64, 48, 100)).ok());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VideoWriter, LeavesNothingWhenItIsKilled) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  TempFolder folder;
  const int unnamed = open(folder.path().c_str(), O_TMPFILE | O_RDWR, 0666);
  if (unnamed < 0) GTEST_SKIP() << "not here: the file system has no files without a name";
  close(unnamed);
  const pid_t child = fork();
  if (child == 0) {
    auto writer = VideoWriter::Start({folder.path() / "v.mp4", 64, 48, 30, 1});
    if (!writer.ok() || !writer.value().Write(Grey(64, 48, 100)).ok()) _exit(1);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VideoWriter, WritesThroughALink) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  TempFolder folder;
  std::ofstream(folder.path() / "target.mp4") << "old";
  std::filesystem::create_symlink("target.mp4", folder.path() / "link.mp4");
  auto writer = VideoWriter::Start({folder.path() / "link.mp4", 64, 48, 30, 1});
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE(writer.value().Write(Grey(64, 48, 100)).ok());
  ASSERT_TRUE(writer.value().Finish().ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.mp4"));
  EXPECT_GT(std::filesystem::file_size(folder.path() / "target.mp4"), 500u);
}

TEST(VideoWriter, PassesOnWhatFfmpegSays) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  auto writer = VideoWriter::Start({"/no/such/folder/v.mp4", 64, 48, 30, 1});
  ASSERT_TRUE(writer.ok());
  const Image image = Grey(64, 48, 100);
  Result<Done> written = writer.value().Write(image);
  while (written.ok()) written = writer.value().Write(image);
  EXPECT_NE(written.error().message.find("No such file or directory"), std::string::npos)
      << written.error().ToString();
}

TEST(VideoWriter, WantsEvenSizesAndSaysSo) {
  const auto writer = VideoWriter::Start({"v.mp4", 65, 48, 30, 1});
  ASSERT_FALSE(writer.ok());
  EXPECT_NE(writer.error().message.find("even"), std::string::npos);
}

TEST(RenderVideo, IsCancelledWithoutATrace) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  TempFolder folder;
  std::atomic<bool> cancel = false;
  Sequence sequence;
  sequence.frame_count = 50;
  sequence.scene = [](int) { return Scene(); };
  sequence.progress = [&](int done) { cancel = done >= 2; };
  sequence.cancel = &cancel;
  SequenceOptions options;
  options.width = 64;
  options.height = 48;
  const auto drawn = RenderVideo(options, sequence, {folder.path() / "v.mp4", 64, 48, 30, 1});
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().code, ErrorCode::kInterrupted);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(RenderVideo, CancelledAfterItsLastFrameTheOldFileStays) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  TempFolder folder;
  std::ofstream(folder.path() / "v.mp4") << "old";
  std::atomic<bool> cancel = false;
  Sequence sequence;
  sequence.frame_count = 3;
  sequence.scene = [](int) { return Scene(); };
  sequence.progress = [&](int done) { cancel = done == 3; };
  sequence.cancel = &cancel;
  SequenceOptions options;
  options.width = 64;
  options.height = 48;
  const auto drawn = RenderVideo(options, sequence, {folder.path() / "v.mp4", 64, 48, 30, 1});
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "v.mp4"), 3u);
}

}  // namespace
}  // namespace hazumi::render
