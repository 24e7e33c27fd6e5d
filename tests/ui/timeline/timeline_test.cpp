// The timeline's header.

#include "tests/ui/user.h"
#include "ui/panels/timeline/layout.h"
#include "ui/panels/window/layout.h"

namespace hazumi::test {
namespace {

using ui::Rect;

Rect HeaderOf(const ui::Editor& editor) {
  return ui::LayOutWindow({0.0f, 0.0f, 720.0f, 560.0f}, editor.settings.shares, 1.0).timeline;
}

ui::Point Middle(const Rect& rect) { return {rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h}; }

TEST(TimelineLayout, NothingOverlapsAtAnyWidth) {
  for (const double scale : {1.0, 1.5}) {
    for (float width = 360.0f; width < 2000.0f; width += 37.0f) {
      const ui::TimelineLayout l = ui::LayOutTimeline({10.0f, 50.0f, width, 30.0f}, scale);
      const std::vector<Rect> row = {l.sheet,    l.to_first, l.previous_key, l.play,
                                     l.next_key, l.to_last,  l.rate,         l.frame,
                                     l.first,    l.last,     l.fps};
      float end = 10.0f;
      for (const Rect& rect : row) {
        if (rect.w <= 0.0f) continue;
        EXPECT_GE(rect.x, end - 0.51f) << width << " " << scale;
        end = rect.right();
      }
      if (width > 800.0f * scale) {
        EXPECT_LE(end, 10.0f + width);
        EXPECT_GT(l.fps.w, 0.0f);
      }
    }
  }
}

TEST(Timeline, ButtonsGoToEndsAndKeys) {
  User user("throw.kfa");
  const ui::TimelineLayout l = ui::LayOutTimeline(HeaderOf(user.editor()), 1.0);
  user.Click(Middle(l.to_last));
  EXPECT_EQ(user.session().frame(), 30.0);
  user.Click(Middle(l.previous_key));
  EXPECT_EQ(user.session().frame(), 27.0);
  user.Click(Middle(l.to_first));
  EXPECT_EQ(user.session().frame(), 0.0);
  user.Click(Middle(l.next_key));
  EXPECT_EQ(user.session().frame(), 3.0);
}

TEST(Timeline, PlaysAndStops) {
  User user("throw.kfa");
  const ui::TimelineLayout l = ui::LayOutTimeline(HeaderOf(user.editor()), 1.0);
  user.Click(Middle(l.play));
  EXPECT_TRUE(user.editor().playback.is_on());
  user.Wait(12);
  EXPECT_GT(user.session().frame(), 2.0);
  EXPECT_EQ(user.editor().playback.dropped(), 0);  // 60 pictures a second for 30 frames
  user.Click(Middle(l.play));
  EXPECT_FALSE(user.editor().playback.is_on());
}

TEST(Timeline, SaysWhatWasDropped) {
  User user("throw.kfa");
  user.editor().Do("time.play");
  for (int i = 0; i < 8; ++i) user.Wait(1);
  EXPECT_EQ(user.editor().playback.dropped(), 0);
  user.Pass(0.2);  // five frames went by unseen, or six
  EXPECT_NEAR(user.editor().playback.dropped(), 5, 1);
}

TEST(Timeline, DraggingTheLastFrameIsOneStep) {
  User user("throw.kfa", {1280, 560});
  const Rect header =
      ui::LayOutWindow({0.0f, 0.0f, 1280.0f, 560.0f}, user.editor().settings.shares, 1.0).timeline;
  const ui::TimelineLayout l = ui::LayOutTimeline(header, 1.0);
  ASSERT_GT(l.last.w, 0.0f);
  const ui::Point from = Middle(l.last);
  user.Drag(from, {from.x + 60.0f, from.y});
  EXPECT_GT(user.project().frames.last, 30);
  EXPECT_EQ(user.num_steps(), 1u);
}

}  // namespace
}  // namespace hazumi::test
