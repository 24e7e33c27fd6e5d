#include "tests/unit/edit/keys/keys_of.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

const Points kPoints = {{0, 0}, {5, 50}, {10, 10}, {20, 20}};

// A knee with kPoints, those on 5 and 10 selected.
Session Knee() {
  Session session;
  SetKeys(&session, "r_knee", kPoints);
  SelectKeys(&session, "r_knee", {5, 10});
  return session;
}

TEST(SelectedKeys, MoveInTimeAndValueAndStaySelected) {
  Session session = Knee();
  Do(&session, "keys.move", {{"frames", 3}, {"value", 1.5}});
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {8, 51.5}, {13, 11.5}, {20, 20}}));
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {8, 13}}}));
  Do(&session, "edit.undo");
  EXPECT_EQ(PointsOf(session, "r_knee"), kPoints);
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
  Do(&session, "edit.redo");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {8, 13}}}));
}

TEST(SelectedKeys, MoveOntoEachOthersPlaces) {
  Session session = Knee();
  Do(&session, "keys.move", {{"frames", 5}});
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {10, 50}, {15, 10}, {20, 20}}));
}

TEST(SelectedKeys, LandOnWholeFramesUnlessTold) {
  Session session = Knee();
  Do(&session, "keys.move", {{"frames", 1.4}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {6, 11}}}));
  Do(&session, "keys.move", {{"frames", 0.25}, {"subframe", true}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {6.25, 11.25}}}));
  Do(&session, "keys.move", {{"value", 1}});  // sideways only if asked
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {6.25, 11.25}}}));
}

TEST(SelectedKeys, DraggedAcrossAKeyAndOnLeaveItThere) {
  Session session = Knee();
  const size_t steps = session.document().num_steps();
  for (const int frames : {2, 6, 10, 13}) {
    Do(&session, "keys.move", {{"frames", frames}, {"drag", "1"}});
  }
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {18, 50}, {20, 20}, {23, 10}}));
  EXPECT_EQ(session.document().num_steps(), steps + 1);
  Do(&session, "keys.move", {{"frames", 10}, {"drag", "1"}});
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {15, 50}, {20, 10}}));  // lands on it
  Do(&session, "edit.end_drag");
  Do(&session, "keys.move", {{"frames", 1}, {"drag", "1"}});  // another drag
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {16, 50}, {21, 10}}));
  Do(&session, "edit.undo");
  Do(&session, "edit.undo");
  EXPECT_EQ(PointsOf(session, "r_knee"), kPoints);
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
}

// Items of every kind go along once in a drag, however often the mouse moves.
TEST(SelectedKeys, DraggedTakeItemsOfEveryKindAlongOnce) {
  Session session = Knee();
  Do(&session, "force.add", {{"kind", "wind"}, {"first", 6}, {"last", 9}});
  Do(&session, "constraint.add",
     {{"kind", "point"}, {"a_joint", "r_wrist"}, {"first", 6}, {"last", 9}});
  Do(&session, "hold.add", {{"joint", "l_wrist"}, {"first", 6}, {"last", 9}});
  Do(&session, "marker.add", {{"frame", 7}, {"name", "here"}});
  Do(&session, "keys.select_all");
  for (const int frames : {2, 4, 5}) {
    Do(&session, "keys.move", {{"frames", frames}, {"drag", "1"}});
  }
  const Project& project = session.project();
  EXPECT_EQ(project.forces.at(0).first_frame, 11);
  EXPECT_EQ(project.forces.at(0).last_frame, 14);
  EXPECT_EQ(project.constraints.at(0).first_frame, 11);
  EXPECT_EQ(project.constraints.at(0).last_frame, 14);
  EXPECT_EQ(project.holds.at(0).first_frame, 11);
  EXPECT_EQ(project.markers.at(0).frame, 12);
}

TEST(SelectedKeys, DraggedBackAreNoStep) {
  Session session = Knee();
  const size_t steps = session.document().num_steps();
  for (const int frames : {2, 10, 0}) {
    Do(&session, "keys.move", {{"frames", frames}, {"drag", "1"}});
  }
  Do(&session, "edit.end_drag");
  EXPECT_EQ(session.document().num_steps(), steps);
  EXPECT_EQ(PointsOf(session, "r_knee"), kPoints);
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
}

TEST(SelectedKeys, ScaleAboutAFrameAndKeepTheShape) {
  Session session = Knee();
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 10}, {"rate", 30}});
  for (const double factor : {1.1, 3.0, 1.5}) {
    Do(&session, "keys.scale", {{"factor", factor}, {"about", 4}, {"drag", "s"}});
  }
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {6, 50}, {13, 10}, {20, 20}}));
  EXPECT_EQ(KeysOf(session, "r_knee")[2].rate, 20.0);
}

TEST(SelectedKeys, ScaleValuesAboutTheirMean) {
  Session session = Knee();
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 10}, {"rate", 30}});
  for (const double values : {3.0, -1.0, 2.0}) {
    Do(&session, "keys.scale", {{"values", values}, {"drag", "s"}});
  }
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {5, 70}, {10, -10}, {20, 20}}));
  EXPECT_EQ(KeysOf(session, "r_knee")[2].rate, 60.0);
}

TEST(SelectedKeys, ScaledOntoEachOtherAreRefused) {
  Session session = Knee();
  EXPECT_EQ(Refused(&session, "keys.scale", {{"factor", 0.01}, {"about", 5}}).ToString(),
            "keys.scale: two selected keys of \"r_knee\" would land on frame 5; subframe keeps "
            "them apart");
  EXPECT_EQ(Refused(&session, "keys.scale", {{"factor", 0}}).ToString(),
            "keys.scale.factor: must be greater than 0");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
  Do(&session, "keys.scale", {{"factor", 0.5}, {"about", 5}, {"subframe", true}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 7.5}}}));
}

TEST(SelectedKeys, DuplicateInOneDrag) {
  Session session = Knee();
  const size_t steps = session.document().num_steps();
  for (const int frames : {0, 1, 5, 10, 20}) {
    Do(&session, "keys.duplicate", {{"frames", frames}, {"drag", "d"}});
  }
  EXPECT_EQ(PointsOf(session, "r_knee"),
            (Points{{0, 0}, {5, 50}, {10, 10}, {20, 20}, {25, 50}, {30, 10}}));
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {25, 30}}}));
  EXPECT_EQ(session.document().num_steps(), steps + 1);
}

TEST(SelectedKeys, Delete) {
  Session session = Knee();
  Do(&session, "keys.delete");
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {20, 20}}));
  EXPECT_TRUE(session.selected_keys().empty());
  Do(&session, "edit.undo");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
}

TEST(SelectedKeys, PasteAtTheCurrentFrame) {
  Session session = Knee();
  SetKeys(&session, "l_knee", {{7, 70}});
  Do(&session, "keys.select", {{"curves", {"l_knee"}}, {"frames", {7}}, {"mode", "add"}});
  Do(&session, "keys.copy");
  Do(&session, "keys.delete");
  Do(&session, "time.frame", {{"frame", 20}});
  Do(&session, "keys.paste");
  EXPECT_EQ(PointsOf(session, "r_knee"), (Points{{0, 0}, {20, 50}, {25, 10}}));
  EXPECT_EQ(PointsOf(session, "l_knee"), (Points{{22, 70}}));
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {20, 25}}, {"l_knee", {22}}}));
}

TEST(SelectedKeys, InterpolationAndHandles) {
  Session session = Knee();
  Do(&session, "keys.interpolation", {{"interpolation", "linear"}});
  Do(&session, "keys.handles", {{"kind", "flat"}});
  for (const ProjectKey& key : KeysOf(session, "r_knee")) {
    const bool selected = key.frame == 5 || key.frame == 10;
    EXPECT_EQ(key.interpolation, selected ? Interpolation::kLinear : Interpolation::kCubic);
    EXPECT_EQ(key.rate, selected ? std::optional(0.0) : std::nullopt);
  }
  Do(&session, "keys.handles", {{"kind", "auto"}});
  EXPECT_FALSE(KeysOf(session, "r_knee")[1].rate);
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
}

TEST(SelectedKeys, SayWhatIsWrong) {
  Session session = Knee();
  EXPECT_EQ(Refused(&session, "keys.handles", {{"kind", "round"}}).ToString(),
            "keys.handles.kind: \"round\" is none of auto, flat, aligned, broken, free_length, "
            "fixed_length");
  EXPECT_EQ(
      Refused(&session, "keys.interpolation", {{"interpolation", "cubik"}}).ToString(),
      "keys.interpolation.interpolation: \"cubik\" is none of hold, linear, quadratic, "
      "cubic, least_acceleration, least_jerk, sine, quintic, exponential, back, bounce, elastic");
  EXPECT_EQ(Refused(&session, "keys.paste", Json::object()).ToString(),
            "keys.paste: no key has been copied");
  SelectKeys(&session, "r_knee", {});
  for (const char* id : {"keys.move", "keys.delete", "keys.copy"}) {
    EXPECT_EQ(Refused(&session, id, Json::object()).ToString(),
              std::string(id) + ": no key is selected");
  }
}

// Keys of two joints on 0, 10 and 20; a region of one of them and all else that has frames between.
Session Timed() {
  Session session;
  for (const char* joint : {"r_elbow_flexion", "l_knee"}) {
    SetKeys(&session, joint, {{0, 0}, {10, 40}, {20, 0}});
  }
  Do(&session, "key.delete", {{"curve", "root.z"}, {"frame", 0}});
  Do(&session, "region.add",
     {{"name", "swing"}, {"first", 10}, {"last", 15}, {"joints", {"r_elbow"}}});
  Do(&session, "placement.set", {{"kind", "pinned"}, {"pin", "l_toe"}, {"first", 5}, {"last", 12}});
  Do(&session, "hold.add", {{"joint", "l_wrist"}, {"first", 2}, {"last", 8}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 14}});
  Do(&session, "marker.add", {{"frame", 14}, {"name", "let go"}});
  Do(&session, "marker.add", {{"frame", 25}, {"name", "after"}});
  return session;
}

// First and last frame of a bar.
template <typename Bar>
std::pair<int, int> EndsOf(const Bar& bar) {
  return {bar.first_frame, bar.last_frame};
}
using Ends = std::pair<int, int>;

TEST(SelectedKeys, StretchedAllTogetherTakeBarsMarkersAndReleasesAlong) {
  Session session = Timed();
  const std::string before = WriteProject(session.project());
  Do(&session, "keys.select_all");
  for (const double factor : {0.5, 1.5, 1.2}) {
    Do(&session, "keys.scale", {{"factor", factor}, {"about", 0}, {"drag", "1"}});
  }
  const Project& project = session.project();
  EXPECT_EQ(EndsOf(project.regions[0]), Ends(12, 18));
  EXPECT_EQ(EndsOf(project.placements[0]), Ends(6, 14));
  EXPECT_EQ(EndsOf(project.holds[0]), Ends(2, 10));
  EXPECT_EQ(project.held_objects[0].release_frame, 17);
  EXPECT_EQ(project.markers[0].frame, 17);
  EXPECT_EQ(project.markers[1].frame, 25);  // no key is beyond it
  Do(&session, "edit.undo");
  EXPECT_EQ(WriteProject(session.project()), before);
}

TEST(SelectedKeys, OfTheJointsOfARegionTakeThatRegionAlong) {
  Session session = Timed();
  SelectKeys(&session, "r_elbow_flexion", {0, 10, 20});
  Do(&session, "keys.move", {{"frames", 2}});
  EXPECT_EQ(EndsOf(session.project().regions[0]), Ends(12, 17));
  EXPECT_EQ(EndsOf(session.project().placements[0]), Ends(5, 12));
  EXPECT_EQ(session.project().markers[0].frame, 14);
}

TEST(SelectedKeys, OfOneFrameOrOfSomeOfTheKeysBetweenTakeNothingAlong) {
  for (const std::vector<double>& frames : {std::vector<double>{10}, std::vector<double>{0, 20}}) {
    Session session = Timed();
    SelectKeys(&session, "r_elbow_flexion", frames);
    Do(&session, "keys.move", {{"frames", 2}});
    EXPECT_EQ(EndsOf(session.project().regions[0]), Ends(10, 15));
  }
}

TEST(SelectedKeys, ScaledInValueLeaveTheBarsWhereTheyAre) {
  Session session = Timed();
  Do(&session, "keys.select_all");
  Do(&session, "keys.scale", {{"values", 0.5}});
  EXPECT_EQ(EndsOf(session.project().regions[0]), Ends(10, 15));
}

}  // namespace
}  // namespace hazumi::test
