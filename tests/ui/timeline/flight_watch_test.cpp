// Flights found in the motion of the document.

#include "ui/panels/timeline/flight_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tests/unit/edit/placement/keyed_jump.h"
#include "ui/panels/sheet/frame.h"
#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {
namespace {

using test::kJumpLanding;
using test::kJumpTakeOff;

void Do(edit::Session* session, const std::string& id, const edit::Json& parameters) {
  const Result<Done> done = session->Run(id, parameters);
  ASSERT_TRUE(done.ok()) << done.error().ToString();
}

FlightAnalysis Found(edit::Session* session) {
  FlightWatch watch;
  watch.Look(session);
  EXPECT_FALSE(watch.is_busy());
  return watch.analysis();
}

TEST(FlightWatch, FindsAKeyedJump) {
  edit::Session session;
  test::KeyJump(9.81, &session);
  const FlightAnalysis found = Found(&session);
  ASSERT_EQ(found.flights.size(), 1u);
  EXPECT_NEAR(found.flights[0].take_off, kJumpTakeOff, 1.5);
  EXPECT_NEAR(found.flights[0].landing, kJumpLanding, 1.5);
  EXPECT_EQ(found.time.verdict, TimeVerdict::kTrue);
  EXPECT_EQ(AlarmText(found.time), "");
}

TEST(FlightWatch, WhoStandsDoesNotFly) {
  edit::Session session;
  EXPECT_TRUE(Found(&session).flights.empty());
}

// Recorded at 60 frames a second, played at 30: gravity is a quarter of what it should be.
TEST(FlightWatch, AWrongFrameRateIsSaidOnceAndRepairedByOneStep) {
  edit::Session session;
  test::KeyJump(9.81 / 4.0, &session);
  FlightWatch watch;
  watch.Look(&session);
  EXPECT_TRUE(watch.TakeAlarm());
  const TimeScale time = watch.analysis().time;
  EXPECT_EQ(time.frame_rate, 60);
  EXPECT_NE(AlarmText(time).find("at 60 frames a second, not 30."), std::string::npos)
      << AlarmText(time);
  EXPECT_EQ(RepairText(time), "Play at 60 frames a second");
  Do(&session, "marker.add", edit::Json::object());
  watch.Look(&session);
  EXPECT_FALSE(watch.TakeAlarm());
  Do(&session, "time.rate", {{"num", 60}, {"keep_shape", true}});
  watch.Look(&session);
  EXPECT_EQ(watch.analysis().time.verdict, TimeVerdict::kTrue);
}

// Arcs too short or too low to tell raise no alarm, offer no repair, and say so.
TEST(FlightText, OfWhatItsIntervalDoesNotBearThereIsNoAlarm) {
  const TimeScale time = JudgeTime({{13.0, 3.0, {}}}, 1.0 / 30.0, 1.7, false, 9.81);
  EXPECT_EQ(AlarmText(time), "");
  EXPECT_EQ(RepairText(time), "");
  EXPECT_NE(UndecidedText(time).find("gravity 6.98 – 19 m/s²"), std::string::npos)
      << UndecidedText(time);
  EXPECT_EQ(UndecidedText(JudgeTime({}, 1.0 / 30.0, 1.7, false, 9.81)), "");
  Flight flight;
  flight.landing = 15.0;
  flight.gravity = {9.8, 0.0, {}};
  EXPECT_EQ(FlightText(flight, 1.0 / 30.0), "0.50 s, 9.8 m/s² (9.41 – 10.2)");
}

TEST(FlightWatch, WhatGravityPlacesIsLeftOut) {
  edit::Session session;
  test::KeyJump(9.81, &session);
  Do(&session, "placement.flight", {{"first", kJumpTakeOff + 1}, {"last", kJumpLanding - 1}});
  EXPECT_TRUE(Found(&session).flights.empty());
}

TEST(FlightWatch, ForgetsADocumentThatIsNoLongerThere) {
  edit::Session session;
  test::KeyJump(9.81 / 4.0, &session);
  FlightWatch watch;
  watch.Look(&session);
  session.Replace(edit::Session().project(), "");
  session.set_patience(0.0);
  watch.Look(&session);
  EXPECT_FALSE(watch.TakeAlarm());
  EXPECT_TRUE(watch.analysis().flights.empty());
}

TEST(FlightWatch, NothingIsLookedAtDuringADrag) {
  edit::Session session;
  test::KeyJump(9.81, &session);
  const edit::Json key = {{"curve", "root.y"}, {"frame", 0}, {"value", 0.1}, {"drag", "a drag"}};
  Do(&session, "key.set", key);
  FlightWatch watch;
  watch.Look(&session);
  EXPECT_TRUE(watch.analysis().flights.empty());
  Do(&session, "edit.end_drag", edit::Json::object());
  watch.Look(&session);
  EXPECT_EQ(watch.analysis().flights.size(), 1u);
}

// As in a window, where it must not be waited for.
TEST(FlightWatch, WorksBesideAndIsThereInAWhile) {
  edit::Session session;
  test::KeyJump(9.81, &session);
  ASSERT_TRUE(session.WholeMotion().ok());
  session.set_patience(0.02);
  FlightWatch watch;
  watch.Look(&session);
  while (watch.is_busy()) watch.Look(&session);
  EXPECT_EQ(watch.analysis().flights.size(), 1u);
}

TEST(FlightMarks, AreAnArcOverTheRulerThatIsFoundUnderTheMouse) {
  edit::Session session;
  test::KeyJump(9.81, &session);
  const SheetFrame frame = LayOutSheetFrame(session, SheetState(), {0, 0, 700, 300}, 1.0);
  const std::vector<FlightMark> marks = FlightMarks(Found(&session).flights, frame);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_NEAR(marks[0].rect.x, frame.axis.XOf(marks[0].flight.take_off), 1e-3);
  EXPECT_NEAR(marks[0].rect.right(), frame.axis.XOf(marks[0].flight.landing), 1e-3);
  EXPECT_LE(marks[0].rect.bottom(), frame.ruler.bottom());
  EXPECT_EQ(FlightMarkAt(marks, marks[0].apex, 1.0), &marks[0]);
  EXPECT_EQ(FlightMarkAt(marks, {marks[0].rect.right() + 20.0f, marks[0].apex.y}, 1.0), nullptr);
}

}  // namespace
}  // namespace hazumi::ui
