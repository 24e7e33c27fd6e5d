#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

// Pinned from 0 to 10, gravity from 10 to 20, pinned again from 20 to 30.
void AddSpans(Session* session) {
  Do(session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 30}});
  Do(session, "placement.set",
     {{"kind", "gravity"}, {"first", 10}, {"last", 20}, {"landing_pin", "r_toe"}});
}

// First and last frame of each span.
std::vector<int> Frames(const Session& session) {
  std::vector<int> frames;
  for (const ProjectPlacement& span : session.project().placements) {
    frames.insert(frames.end(), {span.first_frame, span.last_frame});
  }
  return frames;
}

TEST(PlacementOperators, ANewPlacementTakesTheFramesItIsGiven) {
  Session session;
  Do(&session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 0}, {"last", 30}});
  Do(&session, "placement.set", {{"kind", "gravity"}, {"first", 10}, {"last", 20}});
  ASSERT_EQ(session.project().placements.size(), 3u);
  EXPECT_EQ(session.project().placements[2].first_frame, 20);
  Do(&session, "placement.set", {{"kind", "keyed"}, {"first", 0}, {"last", 30}});
  EXPECT_TRUE(session.project().placements.empty());
}

TEST(PlacementOperators, EditChangesWhatIsGivenOfOneSpan) {
  Session session;
  AddSpans(&session);
  Do(&session, "placement.edit", {{"index", 2}, {"pin", "r_toe"}, {"first", 22}});
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 10, 10, 20, 22, 30}));
  EXPECT_EQ(session.project().placements[2].pin, "r_toe");
  EXPECT_EQ(session.project().placements[1].landing_pin, "r_toe");
}

TEST(PlacementOperators, NeighboursOfAnEditedSpanGiveWay) {
  Session session;
  AddSpans(&session);
  Do(&session, "placement.edit", {{"index", 1}, {"first", 5}, {"last", 30}});
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 5, 5, 30}));
}

TEST(PlacementOperators, DraggedBackTheNeighboursAreAsTheyWere) {
  Session session;
  AddSpans(&session);
  const std::string before = WriteProject(session.project());
  const size_t steps = session.document().num_steps();
  const auto drag = [&](int first, int last) {
    Do(&session, "placement.edit",
       {{"index", 1}, {"first", first}, {"last", last}, {"drag", "a drag"}});
  };
  drag(0, 30);  // alone: its index would be 0 now
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 30}));
  drag(15, 25);
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 10, 15, 25, 25, 30}));
  drag(2, 6);  // inside of the first one
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 2, 2, 6, 6, 10, 20, 30}));
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  drag(10, 20);
  EXPECT_EQ(WriteProject(session.project()), before);
}

TEST(PlacementOperators, ARefusedDragStaysWhereItCouldBeLast) {
  Session session;
  AddSpans(&session);
  Do(&session, "hold.add", {{"joint", "r_ankle"}, {"first", 0}, {"last", 8}});
  const Json drag = {{"index", 1}, {"first", 9}, {"drag", "a drag"}};
  Do(&session, "placement.edit", drag);
  const Error error =
      Refused(&session, "placement.edit", {{"index", 1}, {"first", 4}, {"drag", "a drag"}});
  EXPECT_NE(error.message.find("let go of one"), std::string::npos) << error.message;
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 9, 9, 20, 20, 30}));
}

TEST(PlacementOperators, ASpanThatIsNoLongerOfGravityHasNoLanding) {
  Session session;
  AddSpans(&session);
  Do(&session, "placement.edit", {{"index", 1}, {"kind", "pinned"}, {"pin", "r_toe"}});
  EXPECT_EQ(session.project().placements[1].kind, PlacementKind::kPinned);
  EXPECT_EQ(session.project().placements[1].landing_pin, "");
  Do(&session, "placement.edit", {{"index", 1}, {"kind", "keyed"}});
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 10, 20, 30}));
}

TEST(PlacementOperators, RemoveLeavesTheOthers) {
  Session session;
  AddSpans(&session);
  Do(&session, "placement.remove", {{"index", 1}});
  EXPECT_EQ(Frames(session), (std::vector<int>{0, 10, 20, 30}));
  const Error error = Refused(&session, "placement.remove", {{"index", 2}});
  EXPECT_EQ(error.ToString(),
            "placement.remove.index: there is no placement 2; there are 2, counted from 0");
}

TEST(PlacementOperators, ASpanWithoutFramesIsRefused) {
  Session session;
  AddSpans(&session);
  for (const char* kind : {"pinned", "keyed"}) {
    Refused(&session, "placement.edit", {{"index", 0}, {"kind", kind}, {"last", 0}});
    Refused(&session, "placement.set",
            {{"kind", kind}, {"pin", "l_toe"}, {"first", 12}, {"last", 8}});
  }
  Refused(&session, "placement.edit", {{"index", -1}, {"last", 5}});
}

TEST(HoldOperators, SetChangesWhatIsGivenOfOneHold) {
  Session session;
  Do(&session, "hold.add", {{"joint", "r_ankle"}, {"first", 0}, {"last", 10}});
  Do(&session, "hold.add", {{"joint", "l_wrist"}, {"first", 5}, {"last", 15}});
  const size_t steps = session.document().num_steps();
  for (const int last : {18, 20}) {
    Do(&session, "hold.set", {{"index", 1}, {"last", last}, {"drag", "a drag"}});
  }
  Do(&session, "hold.set", {{"index", 0}, {"joint", "r_toe"}, {"orientation", true}});
  EXPECT_EQ(session.document().num_steps(), steps + 2);
  const std::vector<ProjectHold>& holds = session.project().holds;
  EXPECT_EQ(holds[0], (ProjectHold{"r_toe", true, HoldReach::kLimb, 0, 10, {}}));
  EXPECT_EQ(holds[1], (ProjectHold{"l_wrist", false, HoldReach::kLimb, 5, 20, {}}));
}

TEST(HoldOperators, WhatCannotBeHeldIsRefused) {
  Session session;
  Do(&session, "hold.add", {{"joint", "r_ankle"}, {"first", 0}, {"last", 10}});
  Refused(&session, "hold.set", {{"index", 0}, {"last", 0}});
  Refused(&session, "hold.set", {{"index", 0}, {"joint", "nobody"}});
  EXPECT_EQ(Refused(&session, "hold.set", {{"index", 0}, {"reach", "arm"}}).ToString(),
            "hold.set.reach: \"arm\" is none of limb, body");
  EXPECT_EQ(Refused(&session, "hold.set", {{"index", 1}, {"last", 5}}).ToString(),
            "hold.set.index: there is no hold 1; there are 1, counted from 0");
}

}  // namespace
}  // namespace hazumi::test
