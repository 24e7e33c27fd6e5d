// The project's sound is heard in time: by OpenAL's null device, whose time passes as that of a
// real one.

#include "ui/shell/sound_player.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace hazumi::ui {
namespace {

class SoundPlayerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "ffmpeg is not installed";
    }
    setenv("ALSOFT_DRIVERS", "null", 1);
    const std::string tone = folder_ / "tone.wav";
    const std::string make = "ffmpeg -loglevel error -f lavfi -i sine=duration=20 " + tone;
    ASSERT_EQ(std::system(make.c_str()), 0);
    ASSERT_TRUE(editor_.Do("time.range", {{"first", 0}, {"last", 3000}}));
    // From frame 6 on, 0.2 s.
    ASSERT_TRUE(editor_.Do("audio.set", {{"file", tone}, {"start", 6}}));
    for (int i = 0; i < 3000 && !editor_.sound.sound(); ++i) Pass(0.01);
    ASSERT_TRUE(editor_.sound.sound()) << editor_.sound.error();
  }

  double Now() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  void Follow() {
    editor_.Tick(Now());
    player_.Follow(&editor_);
  }
  void Pass(double seconds) {
    const double until = Now() + seconds;
    do {
      Follow();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (Now() < until);
  }

  const test::TemporaryFolder folder_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Editor editor_;
  SoundPlayer player_;
};

TEST_F(SoundPlayerTest, IsInTimeWithPlaybackAndSilentAfterIt) {
  EXPECT_FALSE(player_.position());
  ASSERT_TRUE(editor_.Do("time.play"));
  const double begin = Now();
  Follow();
  EXPECT_FALSE(player_.position());  // it begins on frame 6
  Pass(0.6);
  ASSERT_TRUE(player_.position());
  EXPECT_NEAR(*player_.position(), Now() - begin - 0.2, 0.15);
  ASSERT_TRUE(editor_.Do("audio.set", {{"mute", true}}));
  Follow();
  EXPECT_FALSE(player_.position());
  ASSERT_TRUE(editor_.Do("audio.set", {{"mute", false}}));
  Follow();
  EXPECT_TRUE(player_.position());
  ASSERT_TRUE(editor_.Do("time.play"));
  Follow();
  EXPECT_FALSE(player_.position());
}

TEST_F(SoundPlayerTest, AFrameThatIsGoneToIsHeardForAMoment) {
  ASSERT_TRUE(editor_.Do("time.frame", {{"frame", 12}}));
  Follow();
  EXPECT_TRUE(player_.position());
  for (int i = 0; i < 50 && player_.position(); ++i) Pass(0.05);
  EXPECT_FALSE(player_.position());
  ASSERT_TRUE(editor_.Do("time.frame", {{"frame", 2}}));  // before its beginning
  Follow();
  EXPECT_FALSE(player_.position());
}

}  // namespace
}  // namespace hazumi::ui
