#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine/base/memory.h"
#include "engine/exchange/read_character.h"
#include "tests/support/temporary_folder.h"

namespace hazumi {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Nothing is left to be reaped, no descriptor is open that was not before.
class ReadInChildTest : public testing::Test {
 protected:
  ReadInChildTest() : open_before_(NumOpen()) {}
  ~ReadInChildTest() override {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
    EXPECT_EQ(NumOpen(), open_before_);
  }
  static long NumOpen() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
  }
  // An error that names the file and says these words.
  static void ExpectError(const Result<Character>& result, ErrorCode code,
                          const std::vector<std::string>& words) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code);
    EXPECT_EQ(result.error().file, "some.fbx");
    for (const std::string& word : words)
      EXPECT_NE(result.error().message.find(word), std::string::npos) << result.error().ToString();
  }

  ReadOptions options_;

 private:
  long open_before_;
};

TEST_F(ReadInChildTest, ACrashIsAnError) {
  options_.trouble = "crash";
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"crashed", "export"});
}

TEST_F(ReadInChildTest, AHangEndsAtTheTimeLimit) {
  options_.trouble = "hang";
  options_.limits.seconds = 0.3;
  const Clock::time_point start = Clock::now();
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"0.3 s", "export"});
  EXPECT_GE(SecondsSince(start), 0.29);
}

TEST_F(ReadInChildTest, ALoopEndsAtTheTimeLimitToo) {
  options_.trouble = "spin";
  options_.limits.seconds = 0.3;
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"0.3 s", "export"});
}

TEST_F(ReadInChildTest, FourGigabytesAreAnError) {
  if (kHasShadowMemory) {
    GTEST_SKIP() << "not here: the sanitizer's shadow memory rules out a limit";
  }
  options_.trouble = "allocate";
  options_.limits.seconds = 120.0;  // to touch it all
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"2048 MB", "export"});
}

TEST_F(ReadInChildTest, GarbageIsAnError) {
  options_.trouble = "garbage";
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"no usable answer"});
}

TEST_F(ReadInChildTest, EndlessOutputIsAnError) {
  options_.trouble = "flood";
  options_.limits.answer = 16u << 20;
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kSyntax,
              {"far too much"});
}

TEST_F(ReadInChildTest, CanBeCancelled) {
  options_.trouble = "hang";
  std::atomic<int> asked = 0;
  options_.is_cancelled = [&] { return ++asked > 3; };
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kInterrupted,
              {"cancelled"});
  EXPECT_EQ(asked, 4);
}

TEST_F(ReadInChildTest, AMissingReaderIsNamed) {
  options_.reader = "/nowhere/hazumi-reader";
  ExpectError(ReadInChild(ReadUse::kCharacter, "some.fbx", options_), ErrorCode::kFailed,
              {"/nowhere/hazumi-reader", "missing", "install"});
}

TEST_F(ReadInChildTest, AReaderThatIsNoProgramIsNamed) {
  const test::TemporaryFolder folder;
  options_.reader = folder / "reader";
  std::ofstream(options_.reader) << "no program";
  const Result<Character> result = ReadInChild(ReadUse::kCharacter, "some.fbx", options_);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().ToString().find(options_.reader), std::string::npos);
}

TEST_F(ReadInChildTest, SeveralThreadsMayRead) {
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      ReadOptions options;
      options.trouble = i % 2 ? "crash" : "garbage";
      for (int k = 0; k < 5; ++k) {
        const Result<Character> result = ReadInChild(ReadUse::kCharacter, "some.fbx", options);
        const bool crashed =
            !result.ok() && result.error().message.find("crashed") != std::string::npos;
        if (crashed == (i % 2 == 1)) ++right;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 20);
}

TEST(ReadCharacter, AFileThatIsNotThereIsSaidAtOnce) {
  const Result<Character> result = ReadCharacter("/nowhere/hero.fbx");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kNoInput);
  EXPECT_EQ(result.error().file, "/nowhere/hero.fbx");
}

TEST(ReadCharacter, AFolderOrADeviceIsNotRead) {
  for (const char* path : {"/tmp", "/dev/zero"}) EXPECT_FALSE(ReadCharacter(path).ok());
}

}  // namespace
}  // namespace hazumi
