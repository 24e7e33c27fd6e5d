// The list of problems: each is found, led to, and put right by its button.

#include "ui/panels/problems/problems.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {
namespace {

class Problems : public testing::Test {
 protected:
  void SetUp() override {
    auto shell = OffscreenShell::Create(&editor_, {640, 480});
    ASSERT_TRUE(shell.ok());
    shell_ = std::move(shell).value();
  }
  void Do(const std::string& id, const Json& parameters) {
    ASSERT_TRUE(editor_.Do(id, parameters)) << editor_.message.text;
  }
  void Pin(const char* joint, int first, int last) {
    Do("placement.set", {{"kind", "pinned"}, {"pin", joint}, {"first", first}, {"last", last}});
  }
  // After the watchers have had their looks.
  std::vector<Problem> Found() {
    for (int i = 0; i < 30; ++i) shell_->Frame();
    return ProblemsOf(&editor_);
  }
  std::vector<Problem> FoundWith(const std::string& text) {
    std::vector<Problem> found = Found();
    EXPECT_EQ(HasProblems(&editor_), !found.empty());
    std::erase_if(found, [&](const Problem& p) { return p.text.find(text) == p.text.npos; });
    return found;
  }

  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

TEST_F(Problems, AreNoneInANewProject) {
  EXPECT_TRUE(Found().empty());
  EXPECT_FALSE(HasProblems(&editor_));
}

TEST_F(Problems, AFigureInTheGroundIsPutOnIt) {
  Do("key.set", {{"curve", "root.z"}, {"frame", 0}, {"value", 0.8}});
  const std::vector<Problem> sunk = FoundWith("in the ground");
  ASSERT_EQ(sunk.size(), 1u);
  EXPECT_EQ(sunk[0].text.rfind("Frames 0 to 30: ", 0), 0u) << sunk[0].text;
  ASSERT_EQ(sunk[0].cures.size(), 1u);
  EXPECT_TRUE(Apply(sunk[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("in the ground").empty());
}

// Problem that is found while efforts are shown.
TEST_F(Problems, FigureThatTips_IsAProblemThatShowsItsFrame) {
  Do("view.overlay", {{"name", "effort"}});
  for (const char* curve : {"l_ankle_flexion", "r_ankle_flexion", "root.angle_y"}) {
    Do("key.set", {{"curve", curve}, {"frame", 0}, {"value", 14}});
  }
  Pin("r_ankle", 0, 30);
  const std::vector<Problem> leaning = FoundWith("the centre of mass is ");
  ASSERT_EQ(leaning.size(), 1u);
  EXPECT_NE(leaning[0].text.find("_toe, and nothing keeps"), std::string::npos) << leaning[0].text;
  GoTo(leaning[0], &editor_);
  EXPECT_EQ(editor_.session().frame(), leaning[0].frame);
  for (const char* curve : {"l_ankle_flexion", "r_ankle_flexion", "root.angle_y"}) {
    Do("key.set", {{"curve", curve}, {"frame", 0}, {"value", 1}});
  }
  EXPECT_TRUE(FoundWith("the centre of mass is ").empty());
}

TEST_F(Problems, MissingSupportIsNotListedOnceEffortsAreHidden) {
  Do("view.overlay", {{"name", "effort"}});
  Do("key.set", {{"curve", "root.z"}, {"frame", 0}, {"value", 2.0}});
  EXPECT_EQ(FoundWith("nothing carries the figure").size(), 1u);
  Do("view.overlay", {{"name", "effort"}});
  EXPECT_TRUE(FoundWith("nothing carries the figure").empty());
  Do("key.set", {{"curve", "root.z"}, {"frame", 0}, {"value", 0.9024}});
  EXPECT_TRUE(Found().empty());
  EXPECT_FALSE(editor_.effort.is_busy());
  Do("view.overlay", {{"name", "effort"}});
  EXPECT_TRUE(Found().empty());
  EXPECT_TRUE(editor_.effort.is_there());
}

// The edge of the support is a toe, which the smaller figure does not have.
TEST_F(Problems, MissingSupportOfALargerFigureIsNotListedOfASmallerOne) {
  for (const bool are_hidden : {false, true}) {
    if (!editor_.viewport.overlays.effort) Do("view.overlay", {{"name", "effort"}});
    Do("file.new", Json::object());
    for (const char* curve : {"l_ankle_flexion", "r_ankle_flexion", "root.angle_y"}) {
      Do("key.set", {{"curve", curve}, {"frame", 0}, {"value", 14}});
    }
    Pin("r_ankle", 0, 30);
    ASSERT_EQ(FoundWith("the centre of mass is ").size(), 1u);
    if (are_hidden) Do("view.overlay", {{"name", "effort"}});
    Do("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/wings.kfa"}});
    for (const Problem& problem : ProblemsOf(&editor_)) {
      EXPECT_EQ(problem.text.find("the centre of mass is "), problem.text.npos) << problem.text;
    }
  }
}

TEST_F(Problems, AJumpOfTheSpeedIsLedTo) {
  Do("key.set", {{"curve", "root.x"}, {"frame", 0}, {"value", 0.0}});
  Do("key.set", {{"curve", "root.x"}, {"frame", 30}, {"value", 3.0}});
  Pin("r_ankle", 0, 12);
  const std::vector<Problem> jumps = FoundWith("At frame 12 ");
  ASSERT_EQ(jumps.size(), 1u);
  GoTo(jumps[0], &editor_);
  EXPECT_EQ(editor_.session().frame(), 12.0);
}

TEST_F(Problems, AHoldOutOfReachIsReachedWithTheBody) {
  Do("key.set", {{"curve", "root.x"}, {"frame", 0}, {"value", 0.0}});
  Do("key.set", {{"curve", "root.x"}, {"frame", 30}, {"value", 0.35}});
  Do("hold.add", {{"joint", "r_wrist"}, {"first", 0}, {"last", 30}});
  Do("key.set", {{"curve", "root.x"}, {"frame", 30}, {"value", 0.9}});
  const std::vector<Problem> errors = FoundWith("out of reach");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(errors[0].is_error);
  GoTo(errors[0], &editor_);
  EXPECT_TRUE(editor_.session().selected_joints().contains("r_wrist_flexion"));
  ASSERT_EQ(errors[0].cures.size(), 1u);
  EXPECT_EQ(errors[0].cures[0].operator_id, "hold.set");
  EXPECT_TRUE(Apply(errors[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_EQ(editor_.session().project().holds[0].reach, HoldReach::kBody);
}

TEST_F(Problems, WhatARegionIsWarnedOfNamesIt) {
  Do("key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 90}});
  Do("region.add", {{"name", "arm"}, {"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 10}});
  const std::vector<Problem> dead = FoundWith("stops dead");
  ASSERT_FALSE(dead.empty());
  EXPECT_EQ(dead[0].text.rfind("arm: ", 0), 0u) << dead[0].text;
  GoTo(dead[0], &editor_);
  EXPECT_EQ(editor_.side.region, editor_.session().project().regions[0].identity.id);
  EXPECT_EQ(editor_.session().frame(), 10.0);
  ASSERT_EQ(dead[0].cures.size(), 1u);
  EXPECT_TRUE(Apply(dead[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("stops dead").empty());
}

TEST_F(Problems, ALandingThatJerksTheBodyIsToldAndAimedAgain) {
  Do("jump.add", {{"x", 1.2}, {"y", 0.0}});
  for (const Problem& problem : Found()) ADD_FAILURE() << problem.text;
  const int landing = editor_.session().project().placements[1].last_frame;
  // Far behind its feet, from where it is flung forward.
  Do("key.set", {{"curve", "root.angle_y"}, {"frame", landing}, {"value", -35}});
  const std::vector<Problem> jerks = FoundWith("as it lands the body is");
  ASSERT_EQ(jerks.size(), 1u);
  EXPECT_GE(jerks[0].frame, landing);
  ASSERT_EQ(jerks[0].cures.size(), 1u);
  EXPECT_TRUE(Apply(jerks[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("as it lands the body is").empty());
}

TEST_F(Problems, NoJerkIsSeenInTheExamples) {
  for (const char* example : {"throw.kfa", "jump.kfa"}) {
    Do("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/" + std::string(example)}});
    EXPECT_TRUE(FoundWith("the body is braked").empty()) << example;
  }
}

TEST_F(Problems, ABallThatFallsThroughTheGroundIsLaidOnIt) {
  Do("held.add_ball", {{"joint", "r_wrist"}, {"release", 3}});
  std::vector<Problem> falls = FoundWith("goes into");
  ASSERT_EQ(falls.size(), 1u);
  ASSERT_EQ(falls[0].cures.size(), 2u);
  EXPECT_TRUE(Apply(falls[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("goes into").empty());
  const ProjectHeldObject& ball = editor_.session().project().held_objects[0];
  const ProjectSphereShape& shape = std::get<ProjectSphereShape>(ball.shape);
  EXPECT_NEAR(ball.position.curves[2].keys.back().value, shape.radius_m, 1e-6);
}

TEST_F(Problems, ABallThatFallsThroughTheGroundMayTouchIt) {
  Do("held.add_ball", {{"joint", "r_wrist"}, {"release", 3}});
  const std::vector<Problem> falls = FoundWith("goes into");
  ASSERT_EQ(falls.size(), 1u);
  EXPECT_TRUE(Apply(falls[0].cures[1], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("goes into").empty());
  EXPECT_TRUE(editor_.session().project().held_objects[0].contacts);
}

TEST_F(Problems, AHandReachesForABallThatWouldJumpIntoIt) {
  Do("time.range", {{"first", 0}, {"last", 30}});
  Do("time.frame", {{"frame", 0}});
  Do("pose.reach", {{"joint", "r_wrist"}, {"x", 0.35}, {"y", -0.05}, {"z", 1.1}});
  Do("held.add_ball", {{"joint", "r_wrist"}});
  Do("time.frame", {{"frame", 15}});
  Do("held.pass", {{"object", "ball"}, {"joint", "l_wrist"}});
  const std::vector<Problem> jumps = FoundWith("jumps by");
  ASSERT_EQ(jumps.size(), 1u);
  EXPECT_EQ(jumps[0].frame, 15.0);
  ASSERT_EQ(jumps[0].cures.size(), 1u);
  EXPECT_TRUE(Apply(jumps[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(FoundWith("jumps by").empty());
}

// One hinge of an arm after the other is warned of in the engine.
TEST_F(Problems, OfOneKindInOneRegionAreOne) {
  for (const char* hinge : {"r_shoulder_flexion", "r_elbow_flexion", "r_wrist_flexion"}) {
    Do("key.set", {{"curve", hinge}, {"frame", 0}, {"value", 40}, {"rate", 90}});
  }
  Do("region.add", {{"name", "arm"}, {"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 10}});
  const std::vector<Problem> dead = FoundWith("stops dead");
  ASSERT_EQ(dead.size(), 1u);
  EXPECT_NE(dead[0].text.find(" more)"), std::string::npos) << dead[0].text;
}

TEST_F(Problems, AFootThatSlidesIsHeldWhereItStands) {
  Do("key.set", {{"curve", "root.x"}, {"frame", 5}, {"value", 0.0}});
  Do("key.set", {{"curve", "root.x"}, {"frame", 15}, {"value", 0.1}});
  std::vector<Problem> slides = FoundWith("on the ground");
  ASSERT_EQ(slides.size(), 2u);  // both feet
  GoTo(slides[0], &editor_);
  EXPECT_GE(editor_.session().frame(), 5.0);
  EXPECT_LT(editor_.session().frame(), 8.0);
  EXPECT_FALSE(editor_.session().selected_joints().empty());
  for (const Problem& slide : slides) {
    ASSERT_EQ(slide.cures.size(), 1u);
    EXPECT_TRUE(Apply(slide.cures[0], &editor_)) << editor_.message.text;
  }
  EXPECT_TRUE(FoundWith("on the ground").empty());
}

TEST_F(Problems, AreSaidInTheLanguageOfTheInterface) {
  Do("key.set", {{"curve", "root.z"}, {"frame", 0}, {"value", 0.8}});
  Do("view.properties", {{"section", "problems"}});
  for (const char* language : {"en", "ja"}) {
    Do("view.language", {{"language", language}});
    ASSERT_EQ(Found().size(), 1u);
    EXPECT_EQ(Found()[0].text.find("in the ground") != std::string::npos, language[0] == 'e');
  }
}

TEST_F(Problems, AHeldTurnOfABodyThatIsLetGoIsFreed) {
  Do("key.set", {{"curve", "root.angle_y"}, {"frame", 0}, {"value", 25.0}});
  Do("placement.set", {{"kind", "gravity"}, {"first", 0}, {"last", 30}});
  Do("region.add",
     {{"name", "body"},
      {"first", 0},
      {"last", 30},
      {"joints", {"waist", "chest", "neck+", "r_shoulder+", "l_shoulder+", "r_hip+", "l_hip+"}},
      {"contacts", true}});
  const std::vector<Problem> held = FoundWith("keys hold its turn");
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].region, editor_.session().project().regions[0].identity.id);
  ASSERT_EQ(held[0].cures.size(), 1u);
  EXPECT_EQ(held[0].cures[0].label, "Let the whole body turn freely");
  EXPECT_TRUE(Apply(held[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_TRUE(editor_.session().animation()->regions[0].root);
  EXPECT_TRUE(FoundWith("keys hold its turn").empty());
}

TEST_F(Problems, AConstraintThatOutlastsItsRegionIsEndedWithIt) {
  Do("region.add", {{"name", "arm"}, {"first", 0}, {"last", 10}, {"joints", {"r_shoulder+"}}});
  Do("constraint.add", {{"name", "grip"},
                        {"kind", "point"},
                        {"a_joint", "r_wrist"},
                        {"b_offset_x", 0.3},
                        {"b_offset_z", 1.0},
                        {"first", 0},
                        {"last", 20},
                        {"arrive", 5}});
  const std::vector<Problem> lasting = FoundWith("no region moves its ends");
  ASSERT_EQ(lasting.size(), 1u);
  EXPECT_EQ(lasting[0].frame, 10.0);
  EXPECT_TRUE(Apply(lasting[0].cures[0], &editor_)) << editor_.message.text;
  EXPECT_EQ(editor_.session().project().constraints[0].last_frame, 10);
  EXPECT_TRUE(FoundWith("no region moves its ends").empty());
}

}  // namespace
}  // namespace hazumi::ui
