#include "tests/unit/edit/keys/keys_of.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

TEST(KeyOperators, SetMakesAKeyInItsPlace) {
  Session session;
  for (const double frame : {20.0, 0.0, 10.5}) {
    Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", frame}, {"value", frame}});
  }
  const auto& keys = KeysOf(session, "r_knee");
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_EQ(keys[1].frame, 10.5);
  EXPECT_EQ(keys[1].value, 10.5);
}

TEST(KeyOperators, SetLeavesAloneWhatIsNotGiven) {
  Session session;
  Do(&session, "key.set",
     {{"curve", "r_knee"}, {"frame", 5}, {"value", 30}, {"rate", 7}, {"interpolation", "linear"}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"value", 40}});
  const ProjectKey& key = KeysOf(session, "r_knee")[0];
  EXPECT_EQ(key.value, 40.0);
  EXPECT_EQ(key.rate, 7.0);
  EXPECT_EQ(key.interpolation, Interpolation::kLinear);
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"auto_rate", true}});
  EXPECT_FALSE(KeysOf(session, "r_knee")[0].rate);
}

TEST(KeyOperators, MoveOntoAnotherKeyTakesItsPlace) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"value", 30}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 9}, {"value", 50}});
  Do(&session, "key.move", {{"curve", "r_knee"}, {"frame", 5}, {"to", 9}, {"by", 1}});
  ASSERT_EQ(KeysOf(session, "r_knee").size(), 1u);
  EXPECT_EQ(KeysOf(session, "r_knee")[0].value, 31.0);
}

TEST(KeyOperators, WhatAFileCouldNotHoldIsRefused) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 9e8}});
  const Error error =
      Refused(&session, "key.move", {{"curve", "r_knee"}, {"frame", 0}, {"by", 9e8}});
  EXPECT_NE(error.message.find("numbers lie between -1e9 and 1e9"), std::string::npos)
      << error.ToString();
}

TEST(KeyOperators, DeleteTakesTheKeysOfTheFrameFromWhatIsSelected) {
  Session session;
  for (const char* curve : {"r_knee", "l_knee", "root.z"}) {
    for (const int frame : {0, 5}) {
      Do(&session, "key.set", {{"curve", curve}, {"frame", frame}, {"value", 1}});
    }
  }
  session.set_frame(5.0);
  session.set_selected_joints({"r_knee"});
  Do(&session, "key.delete");
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 1u);
  EXPECT_EQ(KeysOf(session, "l_knee").size(), 2u);
  session.set_selected_joints({});
  Do(&session, "key.delete");
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 1u);
  EXPECT_EQ(KeysOf(session, "l_knee").size(), 1u);
  EXPECT_EQ(session.project().root.curves[2].keys.back().frame, 0.0);
  Do(&session, "edit.undo");
  EXPECT_EQ(KeysOf(session, "l_knee").size(), 2u);
}

TEST(KeyOperators, DeleteSaysWhereThereIsNoKey) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"value", 1}});
  session.set_frame(7.0);
  const size_t steps = session.document().num_steps();
  EXPECT_EQ(session.Run("key.delete").error().message, "there is no key on frame 7");
  session.set_selected_joints({"l_knee"});
  EXPECT_EQ(session.Run("key.delete", {{"frame", 5}}).error().message,
            "what is selected has no key on frame 5");
  EXPECT_EQ(session.document().num_steps(), steps);
}

TEST(KeyOperators, DraggingAKeyIsOneStep) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"value", 30}});
  for (int i = 0; i < 10; ++i) {
    Do(&session, "key.move", {{"curve", "r_knee"}, {"frame", 5}, {"by", 1}, {"drag", "1"}});
  }
  EXPECT_EQ(session.document().num_steps(), 2u);
  EXPECT_EQ(KeysOf(session, "r_knee")[0].value, 40.0);
  Do(&session, "edit.undo");
  EXPECT_EQ(KeysOf(session, "r_knee")[0].value, 30.0);
}

TEST(KeyOperators, RetimeStretchesTheKeysBetweenTwoFrames) {
  Session session;
  for (const int frame : {0, 5, 10, 20}) {
    Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", frame}, {"value", frame}});
  }
  Do(&session, "key.retime",
     {{"curves", {"r_knee"}}, {"first", 5}, {"last", 10}, {"to_first", 6}, {"to_last", 16}});
  std::vector<double> frames;
  for (const ProjectKey& key : KeysOf(session, "r_knee")) frames.push_back(key.frame);
  EXPECT_EQ(frames, (std::vector<double>{0, 6, 16, 20}));
}

TEST(KeyOperators, InsertKeysWhatIsSeen) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 0}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 30}, {"value", 60}});
  Do(&session, "time.frame", {{"frame", 15}});
  Do(&session, "select.joints", {{"joints", {"r_knee"}}});
  Do(&session, "key.insert");
  EXPECT_NEAR(KeysOf(session, "r_knee")[1].value, 30.0, 1e-9);
}

TEST(KeyOperators, InsertKeysTheWholePoseWhenNothingIsSelected) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "r_knee"}, {"to", 40.0}});
  Do(&session, "time.frame", {{"frame", 15}});
  Do(&session, "key.insert");
  for (const Joint& joint : session.figure().joints()) {
    const std::vector<ProjectKey> keys = KeysOf(session, joint.name);
    ASSERT_FALSE(keys.empty()) << joint.name;
    EXPECT_EQ(keys.back().frame, 15.0) << joint.name;
  }
  EXPECT_EQ(KeysOf(session, "r_knee").back().value, 40.0);
}

TEST(KeyOperators, InsertLeavesTypedAnglesAsTheyAre) {
  Session session;
  for (const double angle : {7.0, 35.0, 59.7, 60.0}) {
    Do(&session, "pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", angle}});
    Do(&session, "key.insert");
    EXPECT_EQ(KeysOf(session, "r_elbow_flexion")[0].value, angle);
  }
}

TEST(KeyOperators, SayWhatIsWrong) {
  Session session;
  EXPECT_EQ(Refused(&session, "key.set", {{"curve", "r_nee"}, {"frame", 0}}).ToString(),
            "key.set.curve: \"r_nee\" is neither a hinge of the figure nor one of root.x, root.y, "
            "root.z, root.angle_z, root.angle_y, root.angle_x");
  EXPECT_EQ(Refused(&session, "key.set", {{"curve", "r_knee"}}).ToString(),
            "key.set.frame: is missing: the key's frame");
  EXPECT_EQ(Refused(&session, "key.set", {{"curve", 3}, {"frame", 0}}).ToString(),
            "key.set.curve: must be a text");
  EXPECT_EQ(Refused(&session, "key.delete", {{"curve", "root.z"}, {"frame", 3}}).ToString(),
            "key.delete.frame: \"root.z\" has no key on frame 3");
  EXPECT_EQ(Refused(&session, "key.paint", Json::object()).ToString(),
            "key.paint: there is no such operator");
  EXPECT_EQ(Refused(&session, "edit.end_drag", {{"steps", 3}}).ToString(),
            "edit.end_drag.steps: there is no such parameter; the operator takes none");
}

}  // namespace
}  // namespace hazumi::test
