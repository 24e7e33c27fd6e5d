// Where keys or a pin put the figure into the ground.

#include <gtest/gtest.h>

#include "ui/panels/sheet/frame.h"
#include "ui/panels/timeline/key_watch.h"

namespace hazumi::ui {
namespace {

constexpr int kAll = 1000;

void Perform(edit::Session* session, const std::string& id, const edit::Json& parameters) {
  const Result<Done> done = session->Run(id, parameters);
  ASSERT_TRUE(done.ok()) << done.error().ToString();
}

// The new project's figure, which stands on the ground, and by keys is so much [m] higher on these
// frames.
edit::Session Standing(const std::vector<std::pair<int, double>>& higher) {
  edit::Session session;
  const double z = session.ValueNow("root.z").value();
  for (const auto& [frame, by] : higher) {
    Perform(&session, "key.set", {{"curve", "root.z"}, {"frame", frame}, {"value", z + by}});
  }
  return session;
}

std::vector<Sinking> SinkingsFound(edit::Session* session) {
  GroundWatch watch;
  watch.Look(session, kAll);
  EXPECT_TRUE(watch.is_done());
  return watch.sinkings();
}

TEST(GroundWatch, WhatStandsOnTheGroundIsNotInIt) {
  edit::Session session = Standing({{0, 0.0}, {10, -0.005}, {20, 0.3}});
  EXPECT_TRUE(SinkingsFound(&session).empty());
}

TEST(GroundWatch, TellsFramesDepthAndWhatIsInTheGround) {
  edit::Session session = Standing({{0, 0.0}, {10, -0.05}, {20, 0.0}});
  const std::vector<Sinking> found = SinkingsFound(&session);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].first, 0);
  EXPECT_LT(found[0].last, 20);
  EXPECT_EQ(found[0].deepest, 10);
  EXPECT_NEAR(found[0].depth, 0.05, 2e-3);
  const std::string joint = session.figure().group(found[0].joint).name;
  EXPECT_TRUE(joint.ends_with("toe") || joint.ends_with("ankle")) << joint;
}

TEST(GroundWatch, GravityIsNotLookedAt) {
  edit::Session session = Standing({{0, 0.0}, {10, -0.05}, {20, -0.05}, {25, 0.0}});
  Perform(&session, "placement.set", {{"kind", "gravity"}, {"first", 0}, {"last", 30}});
  EXPECT_TRUE(SinkingsFound(&session).empty());
}

TEST(GroundWatch, WhatAHandHoldsOnToIsNotLookedAt) {
  edit::Session session = Standing({});
  Perform(&session, "object.add_box",
          {{"name", "rail"}, {"z", 1.0}, {"size_x", 0.2}, {"size_y", 0.2}, {"size_z", 0.2}});
  EXPECT_FALSE(SinkingsFound(&session).empty());
  Perform(&session, "constraint.hold_on", {{"joint", "r_wrist"}, {"object", "rail"}});
  EXPECT_TRUE(SinkingsFound(&session).empty());
}

TEST(GroundWatch, AFewAtATimeItFindsTheSame) {
  edit::Session session = Standing({{0, 0.0}, {10, -0.05}, {20, 0.0}, {30, -0.05}});
  const std::vector<Sinking> all = SinkingsFound(&session);
  EXPECT_EQ(all.size(), 2u);
  GroundWatch watch;
  int num_looks = 0;
  do {
    watch.Look(&session, 4);
  } while (++num_looks < 20 && !watch.is_done());
  EXPECT_EQ(num_looks, 8);  // for 31 frames
  ASSERT_EQ(watch.sinkings().size(), 2u);
  EXPECT_EQ(watch.sinkings()[1].first, all[1].first);
  EXPECT_EQ(watch.sinkings()[1].depth, all[1].depth);
}

TEST(GroundWatch, AfterAnEditOnlyWhatItMovedIsLookedAtAgain) {
  edit::Session session = Standing({{0, 0.0}, {10, 0.0}, {20, 0.0}, {28, 0.0}, {30, 0.0}});
  GroundWatch watch;
  watch.Look(&session, kAll);
  const double z = session.ValueNow("root.z").value();
  Perform(&session, "key.set", {{"curve", "root.z"}, {"frame", 30}, {"value", z - 0.1}});
  watch.Look(&session, 12);  // frames from 20 on: the key changes the tangent at 28
  EXPECT_TRUE(watch.is_done());
  ASSERT_EQ(watch.sinkings().size(), 1u);
  EXPECT_EQ(watch.sinkings()[0].last, 30);
  Perform(&session, "edit.undo", edit::Json::object());
  watch.Look(&session, 12);
  EXPECT_TRUE(watch.sinkings().empty());
}

TEST(GroundWatch, AMarkLiesOverItsFramesOnTheRuler) {
  edit::Session session = Standing({{0, 0.0}, {10, -0.05}, {20, 0.0}});
  const std::vector<Sinking> found = SinkingsFound(&session);
  SheetState state;
  const SheetFrame frame = LayOutSheetFrame(session, state, {0, 0, 700, 300}, 1.0);
  const std::vector<SinkingMark> marks = SinkingMarks(found, frame);
  ASSERT_EQ(marks.size(), 1u);
  const float y = frame.ruler.bottom() - 2.0f;
  const auto is_marked = [&](double at) {
    return SinkingMarkAt(marks, {frame.axis.XOf(at), y}, 1.0) != nullptr;
  };
  EXPECT_TRUE(is_marked(10));
  EXPECT_TRUE(is_marked(found[0].first));
  EXPECT_FALSE(is_marked(found[0].first - 1));
  EXPECT_FALSE(is_marked(found[0].last + 1));
  state.first = 21.0;  // scrolled away
  EXPECT_TRUE(SinkingMarks(found, LayOutSheetFrame(session, state, {0, 0, 700, 300}, 1.0)).empty());
}

}  // namespace
}  // namespace hazumi::ui
