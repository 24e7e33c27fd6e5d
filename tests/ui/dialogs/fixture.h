#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include "ui/panels/dialogs/dialogs.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {

namespace fs = std::filesystem;

// An editor in memory, driven by keys, and a folder of its own.
class Dialogs : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    auto made = OffscreenShell::Create(&editor_, {720, 480});
    ASSERT_TRUE(made.ok());
    shell_ = std::move(made).value();
    Frames();
  }
  void TearDown() override {
    shell_.reset();
    fs::remove_all(folder_);
  }

  void Frames(int count = 3) {
    for (int i = 0; i < count; ++i) shell_->Frame();
  }
  void Press(Chord chord) {
    if (chord.ctrl) shell_->PressKey(kLeftControl, true);
    if (chord.shift) shell_->PressKey(kLeftShift, true);
    if (chord.alt) shell_->PressKey(kLeftAlt, true);
    shell_->PressKey(chord.key, true);
    shell_->Frame();
    shell_->PressKey(chord.key, false);
    if (chord.ctrl) shell_->PressKey(kLeftControl, false);
    if (chord.shift) shell_->PressKey(kLeftShift, false);
    if (chord.alt) shell_->PressKey(kLeftAlt, false);
    Frames();
  }
  void Click(float x, float y) {
    shell_->MoveMouse(x, y);
    shell_->PressButton(0, true);
    shell_->Frame();
    shell_->PressButton(0, false);
    Frames();
  }
  void Type(const std::string& text) {
    shell_->Type(text);
    Frames();
  }
  void Change() { ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "neck_flexion"}, {"by", 9}})); }
  std::string File(const std::string& name) const { return (folder_ / name).string(); }
  Modal modal() const { return editor_.dialogs.modal; }
  bool is_saved() const { return editor_.session().document().is_saved(); }

  // Of this process alone: others may run the same tests.
  fs::path folder_ =
      fs::path(testing::TempDir()) / ("hazumi_dialogs_test_" + std::to_string(getpid()));
  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

}  // namespace hazumi::ui
