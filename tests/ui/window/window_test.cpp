// The editor as a whole, without a display: what is pressed does what menus and scripts do.

#include <gtest/gtest.h>

#include "ui/panels/commands/actions.h"
#include "ui/panels/timeline/layout.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/status_line.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::test {
namespace {

using namespace ui;

class EditorWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    auto shell = OffscreenShell::Create(&editor_, {640, 400});
    ASSERT_TRUE(shell.ok()) << shell.error().ToString();
    shell_ = std::move(shell).value();
    shell_->MoveMouse(200.0f, 100.0f);  // over the viewport
    shell_->Frame();
  }

  void Press(int key, bool ctrl = false) {
    if (ctrl) shell_->PressKey(kLeftControl, true);
    shell_->PressKey(key, true);
    shell_->Frame();
    shell_->PressKey(key, false);
    if (ctrl) shell_->PressKey(kLeftControl, false);
    shell_->Frame();
  }

  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

TEST_F(EditorWindow, KeysStepThroughTime) {
  Press(kRight);
  EXPECT_EQ(editor_.session().frame(), 1.0);
  Press(kLeft);
  EXPECT_EQ(editor_.session().frame(), 0.0);
  Press(kLeft);
  EXPECT_EQ(editor_.session().frame(), 0.0);
}

TEST_F(EditorWindow, ARefusalIsSaidUntilSomethingElseIsDone) {
  EXPECT_FALSE(editor_.Do("pose.rotate", {{"joint", "r_nee"}, {"to", 9}}));
  const std::string refusal = editor_.message.text;
  EXPECT_NE(refusal.find("r_nee"), std::string::npos);
  editor_.Do("edit.end_drag");
  EXPECT_EQ(editor_.message.text, refusal);
  ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "r_knee"}, {"to", 9}}));
  EXPECT_EQ(editor_.message.text, "");
}

TEST_F(EditorWindow, WhatWasSaidOfADocumentGoesWithIt) {
  editor_.Say("Saved.");
  ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "r_knee"}, {"to", 9}}));
  EXPECT_EQ(editor_.message.text, "Saved.");
  ASSERT_TRUE(editor_.Do("file.new"));
  EXPECT_EQ(editor_.message.text, "");
}

TEST_F(EditorWindow, EnterRecoversWhatACrashLeftAndEscLeavesItForTheNextTime) {
  std::vector<std::string> answers;
  editor_.recovery.answer = [&](const edit::AbandonedJournal& journal, bool recovers) {
    answers.push_back(journal.file + (recovers ? " recovered" : " thrown away"));
  };
  edit::AbandonedJournal journal;
  for (const int key : {kEnter, kEscape}) {
    for (const char* file : {"whole", "damaged"}) {
      journal.file = file;
      journal.damage.reset();
      if (journal.file == "damaged") journal.damage = Error{ErrorCode::kSyntax, "", "", "torn"};
      editor_.recovery.journals = {journal};
      for (int i = 0; i < 3; ++i) shell_->Frame();
      Press(key);
      EXPECT_TRUE(editor_.recovery.journals.empty()) << file;
      shell_->Frame();
    }
  }
  EXPECT_EQ(answers, (std::vector<std::string>{"whole recovered"}));
}

TEST(EditorWindowSizes, NoneIsTooSmall) {
  for (const render::PictureSize& size :
       {render::PictureSize{1, 1}, {50, 100}, {1280, 100}, {1280, 60}, {40, 800}, {200, 150}}) {
    for (const double scale : {1.0, 2.0}) {
      for (const SheetKind kind : {SheetKind::kDopeSheet, SheetKind::kGraph}) {
        SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height));
        Editor editor;
        editor.settings.scale = scale;
        editor.sheet.kind = kind;
        auto shell = OffscreenShell::Create(&editor, size);
        ASSERT_TRUE(shell.ok()) << shell.error().ToString();
        for (int i = 0; i < 3; ++i) shell.value()->Frame();
      }
    }
  }
}

TEST_F(EditorWindow, ATypedFrameOutsideOfTheAnimationIsSaid) {
  for (int i = 0; i < 3; ++i) shell_->Frame();
  const auto panels = LayOutWindow({0.0f, 0.0f, 640.0f, 400.0f}, editor_.settings.shares, 1.0);
  const Rect field = LayOutTimeline(panels.timeline, 1.0).frame;
  const auto type = [&](const char* number) {
    shell_->MoveMouse(field.x + 0.5f * field.w, field.y + 0.5f * field.h);
    for (const bool is_down : {true, false, true, false}) {
      shell_->PressButton(0, is_down);
      shell_->Frame();
    }
    shell_->Type(number);
    shell_->Frame();
    Press(kEnter);
    for (int i = 0; i < 40; ++i) shell_->Frame();  // no double click with what comes next
  };
  type("77");
  EXPECT_EQ(editor_.session().frame(), 30.0);
  EXPECT_EQ(editor_.message.text, "Frame 77 is outside of the animation, 0 to 30.");
  type("12");
  EXPECT_EQ(editor_.session().frame(), 12.0);
  EXPECT_EQ(editor_.message.text, "");
}

TEST_F(EditorWindow, AKeyThatARegionKeepsFromActingIsSaid) {
  const auto pose = [&](const char* joint, int frame) {
    ASSERT_TRUE(editor_.Do("time.frame", {{"frame", frame}}));
    editor_.Say("");
    ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", joint}, {"by", 5}})) << editor_.message.text;
  };
  ASSERT_TRUE(editor_.Do("region.add",
                         {{"name", "arm"}, {"joints", {"r_elbow+"}}, {"first", 5}, {"last", 15}}));
  for (const int frame : {5, 16}) {
    pose("r_elbow_flexion", frame);
    EXPECT_EQ(editor_.message.text, "") << frame;
  }
  pose("l_elbow_flexion", 10);
  EXPECT_EQ(editor_.message.text, "");
  for (const int frame : {6, 15}) {
    pose("r_elbow_flexion", frame);
    EXPECT_NE(editor_.message.text.find("region \"arm\" moves r_elbow_flexion"), std::string::npos)
        << frame << editor_.message.text;
    EXPECT_FALSE(editor_.message.is_error);
  }
  ASSERT_TRUE(editor_.Do("region.split", {{"region", "arm"}, {"frame", 10}}));
}

TEST_F(EditorWindow, UndoIsAKeyAway) {
  ASSERT_TRUE(editor_.Do("project.rename", {{"name", "Changed"}}));
  Press('Z', true);
  EXPECT_NE(editor_.session().project().name, "Changed");
}

TEST_F(EditorWindow, UndoAndRedoGoToTheFrameThatTheyChange) {
  edit::Session& session = editor_.session();
  session.set_frame(12.0);
  ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "r_knee"}, {"to", 40}}));
  session.set_frame(3.0);
  Press('Z', true);
  EXPECT_EQ(session.frame(), 12.0);
  EXPECT_EQ(editor_.message.text, "Undo: Rotate joint (F12)");
  session.set_frame(3.0);
  editor_.sheet.first = 20.0;
  editor_.sheet.last = 26.0;
  ASSERT_TRUE(editor_.Do("edit.redo"));
  EXPECT_EQ(session.frame(), 12.0);
  EXPECT_EQ(editor_.sheet.first, 9.0);  // the sheet shows it, too
  EXPECT_EQ(editor_.sheet.last, 15.0);
  EXPECT_EQ(editor_.message.text, "Redo: Rotate joint (F12)");
}

TEST_F(EditorWindow, UndoStaysWhereTheChangeIsSeenAndWhereItHasNoFrame) {
  edit::Session& session = editor_.session();
  ASSERT_TRUE(editor_.Do("region.add", {{"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}}));
  session.set_frame(10.0);
  Press('Z', true);
  EXPECT_EQ(session.frame(), 10.0);
  ASSERT_TRUE(editor_.Do("project.rename", {{"name", "Changed"}}));
  Press('Z', true);
  EXPECT_EQ(session.frame(), 10.0);
}

TEST_F(EditorWindow, PlaysInRealTime) {
  Press(kSpace);
  ASSERT_TRUE(editor_.playback.is_on());
  const double before = editor_.session().frame();
  shell_->Frame(0.5);
  EXPECT_NEAR(editor_.session().frame() - before, 15.0, 1.0);
  Press(kSpace);
  EXPECT_FALSE(editor_.playback.is_on());
}

TEST_F(EditorWindow, EscapeEndsPlaybackWhereItBegan) {
  ASSERT_TRUE(editor_.Do("time.frame", {{"frame", 4}}));
  Press(kSpace);
  shell_->Frame(0.5);
  Press(kEscape);
  EXPECT_FALSE(editor_.playback.is_on());
  EXPECT_EQ(editor_.session().frame(), 4.0);
}

// A motion that takes far longer than a picture may take: a swing of six seconds, nearly without
// friction, from limit to limit, as accurate as can be.
class LongMotion : public EditorWindow {
 protected:
  void SetUp() override {
    EditorWindow::SetUp();
    ASSERT_TRUE(editor_.Do("time.range", {{"last", 500}}));
    Key("r_shoulder_flexion", 95, -60.0);
    Key("r_shoulder_flexion", 100, 60.0);
    Key("l_shoulder_abduction", 100, 60.0);
    ASSERT_TRUE(editor_.Do("region.add", {{"first", 100},
                                          {"last", 280},
                                          {"joints", {"r_shoulder+", "l_shoulder+"}},
                                          {"friction", 0.995}}));
    ASSERT_TRUE(editor_.Do("region.set", {{"region", "region"}, {"tolerance", 1e-10}}));
    editor_.session().set_patience(1e-3);
    shell_->Frame();
  }
  void Key(const char* curve, int frame, double value) {
    ASSERT_TRUE(editor_.Do("key.set", {{"curve", curve}, {"frame", frame}, {"value", value}}));
  }
  bool IsBusy() const { return editor_.session().bake()->is_busy(); }
};

TEST_F(LongMotion, GoesOnBesideAndIsThereInTheEnd) {
  ASSERT_TRUE(IsBusy());
  EXPECT_NE(BakingText(editor_).find("Computing the motion"), std::string::npos);
  const Result<Done> refused = editor_.Invoke("region.to_keys", {{"region", "region"}});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("still being computed"), std::string::npos);
  EXPECT_TRUE(editor_.Do("project.rename", {{"name", "Edited meanwhile"}}));
  shell_->Frame();
  for (int i = 0; i < 4000 && IsBusy(); ++i) shell_->Frame();
  shell_->Frame();
  EXPECT_EQ(BakingText(editor_), "");
  EXPECT_TRUE(editor_.session().MotionTo(500).ok());
}

TEST_F(LongMotion, EscapeStopsItAndItCanBeWantedAgain) {
  ASSERT_TRUE(IsBusy());
  Press(kEscape);
  EXPECT_EQ(BakingText(editor_), "The motion is not computed");
  for (int i = 0; i < 3; ++i) shell_->Frame();
  EXPECT_FALSE(IsBusy());
  EXPECT_TRUE(editor_.Do("motion.compute"));
  shell_->Frame();
  EXPECT_TRUE(IsBusy());
}

TEST_F(EditorWindow, SaysWhatWasRefused) {
  EXPECT_FALSE(editor_.Do("edit.redo"));
  EXPECT_TRUE(editor_.message.is_error);
  EXPECT_NE(editor_.message.text.find("nothing to redo"), std::string::npos);
}

TEST_F(EditorWindow, DrawsTheSamePictureForTheSameState) {
  for (int i = 0; i < 3; ++i) shell_->Frame();
  const Image first = shell_->picture();
  for (int i = 0; i < 3; ++i) shell_->Frame();
  EXPECT_EQ(first.rgba, shell_->picture().rgba);
  ASSERT_TRUE(editor_.Do("view.theme", {{"dark", false}}));
  for (int i = 0; i < 3; ++i) shell_->Frame();
  EXPECT_NE(first.rgba, shell_->picture().rgba);
}

}  // namespace
}  // namespace hazumi::test
