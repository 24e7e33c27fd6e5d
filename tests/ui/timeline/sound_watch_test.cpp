// The project's sound in the sheets.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/support/temporary_folder.h"
#include "ui/panels/sheet/wave.h"
#include "ui/panels/timeline/media_watch.h"

namespace hazumi::ui {
namespace {

void SetSound(edit::Session* session, const std::string& id, const edit::Json& parameters) {
  const Result<Done> done = session->Run(id, parameters);
  ASSERT_TRUE(done.ok()) << done.error().ToString();
}

void Wait(const edit::Session& session, SoundWatch* watch) {
  watch->Look(session);
  while (watch->is_busy()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    watch->Look(session);
  }
}

TEST(SoundWatch, ReadsTheProjectsSoundAndAnotherOneOnceItIsSet) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  const test::TemporaryFolder folder;
  const std::string tone = folder / "tone.wav", broken = folder / "broken.wav";
  const std::string make = "ffmpeg -loglevel error -f lavfi -i sine=duration=1.5 " + tone;
  ASSERT_EQ(std::system(make.c_str()), 0);
  std::ofstream(broken) << "no sound";
  edit::Session session;
  SoundWatch watch;
  Wait(session, &watch);
  EXPECT_FALSE(watch.peaks());
  EXPECT_EQ(watch.error(), "");
  SetSound(&session, "audio.set", {{"file", tone}});
  Wait(session, &watch);
  ASSERT_TRUE(watch.peaks()) << watch.error();
  EXPECT_NEAR(watch.peaks()->seconds(), 1.5, 1e-3);
  SetSound(&session, "audio.set", {{"file", broken}});
  Wait(session, &watch);
  EXPECT_FALSE(watch.peaks());
  EXPECT_NE(watch.error().find("ffmpeg finds no sound in it"), std::string::npos);
  SetSound(&session, "audio.remove", edit::Json::object());
  Wait(session, &watch);
  EXPECT_EQ(watch.error(), "");
}

// Half a second of silence, a click, and silence again.
Sound Click() {
  Sound sound{{1000, 1}, std::vector<std::int16_t>(1000, 0)};
  sound.samples[500] = 16384;
  return sound;
}

TEST(SoundRow, HasTheWaveOnItsFramesAtAnyZoom) {
  const Peaks peaks(Click());
  edit::Session session;
  SetSound(&session, "audio.set", {{"file", "a.wav"}, {"start", 10}});
  const ProjectAudio& audio = *session.project().audio;
  const FrameRate rate{30, 1};
  for (const double frames : {0.5, 60.0, 2000.0}) {
    SheetState state;
    state.first = 25.0 - 0.4 * frames;  // the click is 15 frames behind the start
    state.last = state.first + frames;
    const SheetFrame frame = LayOutSheetFrame(session, state, {0.0f, 0.0f, 650.0f, 300.0f}, 1.0);
    const float middle = frame.sound.y + 0.5f * frame.sound.h;
    int num_loud = 0;
    for (const WaveColumn& column : WaveColumns(peaks, audio, rate, frame)) {
      EXPECT_GE(column.x + 1.0f, frame.axis.XOf(10.0));
      EXPECT_LE(column.x, frame.axis.XOf(40.0));
      if (middle - column.top < 2.0f) continue;
      ++num_loud;
      // A sample is 0.03 frames long.
      EXPECT_GE(column.x + 1.5f, frame.axis.XOf(25.0)) << frames;
      EXPECT_LE(column.x - 0.5f, frame.axis.XOf(25.03)) << frames;
    }
    EXPECT_GE(num_loud, 1) << frames;
  }
}

TEST(SoundRow, IsAsHighAsTheSoundIsLoudAndThereWithASoundAlone) {
  edit::Session session;
  const Rect rect = {0.0f, 0.0f, 650.0f, 300.0f};
  const SheetFrame without = LayOutSheetFrame(session, SheetState(), rect, 1.0);
  EXPECT_EQ(without.sound.h, 0.0f);
  const auto highest = [&](double gain) {
    SetSound(&session, "audio.set", {{"file", "a.wav"}, {"gain", gain}});
    const SheetFrame frame = LayOutSheetFrame(session, SheetState(), rect, 1.0);
    EXPECT_EQ(frame.tracks.y, without.tracks.y + frame.sound.h);
    float high = 0.0f;
    for (const WaveColumn& column :
         WaveColumns(Peaks(Click()), *session.project().audio, {30, 1}, frame)) {
      high = std::max(high, (frame.sound.y + 0.5f * frame.sound.h - column.top) /
                                (0.5f * frame.sound.h - 1.0f));
      EXPECT_GE(column.top, frame.sound.y);
    }
    return high;
  };
  EXPECT_NEAR(highest(0.0), 0.5, 0.04);
  EXPECT_NEAR(highest(-6.0), 0.25, 0.04);
  EXPECT_NEAR(highest(20.0), 1.0, 0.04);
}

}  // namespace
}  // namespace hazumi::ui
