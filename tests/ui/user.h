#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "engine/project/project_writer.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::test {

// Somebody before an editor without a display, with a mouse and a keyboard.
class User {
 public:
  explicit User(const std::string& example = "", render::PictureSize size = {720, 560}) {
    if (!example.empty()) {
      editor_.Do("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/" + example}});
    }
    editor_.settings.shares.bottom = 0.7;
    auto made = ui::OffscreenShell::Create(&editor_, size);
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().ToString());
    shell_ = std::move(made).value();
    MoveTo({1.0f, 1.0f});
    Wait();
  }

  ui::Editor& editor() { return editor_; }
  edit::Session& session() { return editor_.session(); }
  const Project& project() { return session().project(); }
  const std::vector<uint8_t>& picture() { return shell_->picture().rgba; }
  std::string text() { return WriteProject(project()); }
  size_t num_steps() { return session().document().num_steps(); }

  void Wait(int frames = 2) {
    for (int i = 0; i < frames; ++i) shell_->Frame();
  }
  void Pass(double seconds) { shell_->Frame(seconds); }
  void MoveTo(ui::Point p) {
    shell_->MoveMouse(p.x, p.y);
    shell_->Frame();
  }
  void Hold(int button, bool is_down) {
    shell_->PressButton(button, is_down);
    shell_->Frame();
  }
  void Click(ui::Point p, int button = 0) {
    MoveTo(p);
    Hold(button, true);
    Hold(button, false);
    Wait(1);
  }
  // Presses a button and goes there in some steps; does not let go.
  void Pull(ui::Point from, ui::Point to, int button = 0) {
    MoveTo(from);
    Hold(button, true);
    for (const float s : {0.25f, 0.5f, 0.75f, 1.0f}) {
      MoveTo({std::lerp(from.x, to.x, s), std::lerp(from.y, to.y, s)});
    }
  }
  void Drag(ui::Point from, ui::Point to, int button = 0) {
    Pull(from, to, button);
    Hold(button, false);
    Wait(1);
  }
  void DragWith(int modifier, ui::Point from, ui::Point to, int button = 0) {
    shell_->PressKey(modifier, true);
    Drag(from, to, button);
    shell_->PressKey(modifier, false);
    Wait(1);
  }
  void Press(int key, int modifier = ui::kNoKey) {
    if (modifier != ui::kNoKey) shell_->PressKey(modifier, true);
    shell_->PressKey(key, true);
    shell_->Frame();
    shell_->PressKey(key, false);
    if (modifier != ui::kNoKey) shell_->PressKey(modifier, false);
    shell_->Frame();
  }
  void PressWithShift(int key, int modifier) {
    shell_->PressKey(ui::kLeftShift, true);
    Press(key, modifier);
    shell_->PressKey(ui::kLeftShift, false);
    Wait(1);
  }
  void ClickWith(int modifier, ui::Point p) {
    shell_->PressKey(modifier, true);
    Click(p);
    shell_->PressKey(modifier, false);
    Wait(1);
  }
  void TurnWith(int modifier, float notches) {
    shell_->PressKey(modifier, true);
    Turn(notches);
    shell_->PressKey(modifier, false);
    Wait(1);
  }
  void Type(const std::string& text) {
    shell_->Type(text);
    Wait();
  }
  void Turn(float notches) {
    shell_->TurnWheel(notches);
    shell_->Frame();
  }

 private:
  ui::Editor editor_;
  std::unique_ptr<ui::OffscreenShell> shell_;
};

}  // namespace hazumi::test
