// Which keys are selected, and what becomes of that when they are edited.

#include "tests/unit/edit/keys/keys_of.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

// Knees with keys on frames 0, 5 and 10 (left: 0, 5 and 12).
Session Knees() {
  Session session;
  SetKeys(&session, "r_knee", {{0, 0}, {5, 50}, {10, 10}});
  SetKeys(&session, "l_knee", {{0, 0}, {5, 50}, {12, 10}});
  return session;
}

TEST(KeySelection, SelectsByCurveAndFrame) {
  Session session = Knees();
  const auto select = [&](const char* mode, const Json& curves, const Json& frames) {
    Do(&session, "keys.select", {{"curves", curves}, {"frames", frames}, {"mode", mode}});
    return session.selected_keys();
  };
  using S = KeySelection;
  EXPECT_EQ(select("replace", {"r_knee", "l_knee"}, {0, 12}),
            (S{{"r_knee", {0}}, {"l_knee", {12}}}));
  EXPECT_EQ(select("add", {"r_knee"}, {5}), (S{{"r_knee", {0, 5}}, {"l_knee", {12}}}));
  EXPECT_EQ(select("toggle", {"r_knee", "r_knee"}, {0, 10}),
            (S{{"r_knee", {5, 10}}, {"l_knee", {12}}}));
  EXPECT_EQ(select("remove", {"l_knee", "l_knee"}, {0, 12}), (S{{"r_knee", {5, 10}}}));
  EXPECT_EQ(select("replace", Json::array(), Json::array()), S());
  EXPECT_EQ(session.document().num_steps(), 6u);  // the keys; selecting is no step
}

TEST(KeySelection, SelectsAllColumnsAndSides) {
  Session session = Knees();
  Do(&session, "keys.select_all");
  EXPECT_EQ(NumKeys(session.selected_keys()), 7u);  // and the root's
  Do(&session, "keys.select_all", {{"curves", {"l_knee"}}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"l_knee", {0, 5, 12}}}));
  SelectKeys(&session, "r_knee", {5});
  Do(&session, "keys.select_column");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5}}, {"l_knee", {5}}}));
  Do(&session, "keys.select_column", {{"frame", 12}, {"mode", "add"}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5}}, {"l_knee", {5, 12}}}));
  Do(&session, "keys.select_side", {{"side", "after"}, {"frame", 10}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {10}}, {"l_knee", {12}}}));
  Do(&session, "time.frame", {{"frame", 5}});
  Do(&session, "keys.select_side", {{"side", "before"}, {"curves", {"r_knee"}}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {0, 5}}}));
}

TEST(KeySelection, WhatVanishesFallsOutAndComesBackByUndo) {
  Session session = Knees();
  SelectKeys(&session, "r_knee", {5, 10});
  Do(&session, "key.delete", {{"curve", "r_knee"}, {"frame", 5}});
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {10}}}));
  Do(&session, "edit.undo");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5, 10}}}));
  Do(&session, "edit.redo");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {10}}}));
}

TEST(KeySelection, UndoOfOtherEditsLeavesItAlone) {
  Session session = Knees();
  SelectKeys(&session, "r_knee", {5});
  Do(&session, "project.rename", {{"name", "a"}});
  SelectKeys(&session, "l_knee", {12});
  Do(&session, "edit.undo");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"l_knee", {12}}}));
  Do(&session, "edit.undo");  // the key on 12 was made
  EXPECT_TRUE(session.selected_keys().empty());
}

TEST(KeySelection, AnotherProjectBeginsWithout) {
  Session session = Knees();
  Do(&session, "keys.select_all");
  Do(&session, "file.new");
  EXPECT_TRUE(session.selected_keys().empty());
}

TEST(KeySelection, SaysWhatIsWrong) {
  Session session = Knees();
  SelectKeys(&session, "r_knee", {5});
  const auto refused = [&](const char* id, const Json& parameters) {
    return Refused(&session, id, parameters).ToString();
  };
  EXPECT_EQ(refused("keys.select", {{"curves", {"r_knee"}}, {"frames", {3}}}),
            "keys.select.frames: \"r_knee\" has no key on frame 3");
  EXPECT_EQ(refused("keys.select", {{"curves", {"nobody"}}, {"frames", {3}}}),
            "keys.select.frames: \"nobody\" has no key on frame 3");
  EXPECT_EQ(refused("keys.select", {{"curves", {"r_knee"}}, {"frames", {0, 5}}}),
            "keys.select.frames: there are 2 for 1 curves; give one for each");
  EXPECT_EQ(refused("keys.select", {{"curves", {"r_knee"}}, {"frames", {"0"}}}),
            "keys.select.frames: must be a list of numbers");
  EXPECT_EQ(refused("keys.select_all", {{"mode", "most"}}),
            "keys.select_all.mode: \"most\" is none of replace, add, remove, toggle");
  EXPECT_EQ(refused("keys.select_all", {{"curves", {"r_wrist"}}}),
            "keys.select_all.curves: there is no curve \"r_wrist\" with keys");
  EXPECT_EQ(refused("keys.select_side", {{"side", "above"}}),
            "keys.select_side.side: \"above\" is none of before, after");
  EXPECT_EQ(session.selected_keys(), (KeySelection{{"r_knee", {5}}}));
  SelectKeys(&session, "r_knee", {});
  EXPECT_EQ(refused("keys.select_column", Json::object()),
            "keys.select_column.frame: no key is selected; select one or give a frame");
}

}  // namespace
}  // namespace hazumi::test
