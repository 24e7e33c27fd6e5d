// Synchronization of the project's sound with playback. OpenAL's null device runs in real time; the
// time of the editor is simulated.

#include "ui/shell/sound_player.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
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
    while (!editor_.sound.sound() && editor_.sound.error().empty()) {
      Follow();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(editor_.sound.sound()) << editor_.sound.error();
  }

  void Follow() {
    editor_.Tick(now_);
    player_.Follow(&editor_);
  }
  void Pass(double seconds) {
    now_ += seconds;
    Follow();
  }

  const test::TemporaryFolder folder_;
  double now_ = 0.0;  // simulated time of the editor [s]
  Editor editor_;
  SoundPlayer player_;
};

TEST_F(SoundPlayerTest, IsInTimeWithPlaybackAndSilentAfterIt) {
  EXPECT_FALSE(player_.position());
  ASSERT_TRUE(editor_.Do("time.play"));
  Follow();
  EXPECT_FALSE(player_.position());  // it begins on frame 6
  Pass(0.6);
  // Expected position once the sound has been started; increases until the time of the device
  // reaches it.
  double seconds = 0.4;
  while (!player_.position() || std::abs(*player_.position() - seconds) > 0.06) {
    seconds += 0.2;
    Pass(0.2);
    ASSERT_LT(seconds, 15.0) << "it is never in time";
  }
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
  while (player_.position()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_TRUE(editor_.Do("time.frame", {{"frame", 2}}));  // before its beginning
  Follow();
  EXPECT_FALSE(player_.position());
}

}  // namespace
}  // namespace hazumi::ui
