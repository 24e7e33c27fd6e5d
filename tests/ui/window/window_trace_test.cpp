#include "ui/shell/window_trace.h"

#include <gtest/gtest.h>

namespace hazumi::test {
namespace {

using ui::WindowTrace;

TEST(WindowTrace, TimesOnlyEventsThatChangeTheProject) {
  WindowTrace trace;
  for (int i = 1; i <= 100; ++i) {
    trace.AddEvent({0.001 * i, true, i > 97});
    for (int k = 0; k < 3; ++k) trace.AddEvent({1e-5, false, false});
  }
  EXPECT_EQ(trace.events(), 400);
  EXPECT_EQ(trace.changes(), 100);
  EXPECT_EQ(trace.behind(), 3);
  EXPECT_DOUBLE_EQ(trace.TimeOf(0.5), 0.050);
  EXPECT_DOUBLE_EQ(trace.TimeOf(0.99), 0.099);
  EXPECT_DOUBLE_EQ(trace.TimeOf(1.0), 0.100);
}

TEST(WindowTrace, TimesWhatIsTypedApart) {
  WindowTrace trace;
  for (int i = 1; i <= 100; ++i) trace.AddEvent({0.001 * i, false, false, i % 2 == 0});
  EXPECT_EQ(trace.typed(), 50);
  EXPECT_DOUBLE_EQ(trace.TypingTimeOf(0.5), 0.050);
  EXPECT_EQ(trace.changes(), 0);
}

TEST(WindowTrace, HasNoTimeWithoutAChange) {
  WindowTrace trace;
  trace.AddEvent({0.1, false, false});
  EXPECT_EQ(trace.TimeOf(0.5), 0.0);
}

TEST(WindowTrace, AFrameIsLateAfterTheNextOneWasDue) {
  WindowTrace trace;
  for (const double late : {0.001, 0.030, 0.034, 0.150}) trace.AddFrame({late, 1.0 / 30.0, 0});
  EXPECT_EQ(trace.passed_over(), 0);
  EXPECT_EQ(trace.frames(), 4);
  EXPECT_EQ(trace.late_frames(), 2);
  trace.AddFrame({0.01, 1.0 / 30.0, 5});
  EXPECT_EQ(trace.passed_over(), 5);
  EXPECT_EQ(trace.latest(), 0.150);
}

}  // namespace
}  // namespace hazumi::test
