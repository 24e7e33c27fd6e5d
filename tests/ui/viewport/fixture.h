#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {

// A small editor without a display, and where its joints are seen.
class ViewportFixture : public testing::Test {
 protected:
  explicit ViewportFixture(render::PictureSize size = {520, 380}) : size_(size) {}

  void SetUp() override {
    auto made = OffscreenShell::Create(&editor_, size_);
    ASSERT_TRUE(made.ok()) << made.error().ToString();
    shell_ = std::move(made).value();
    editor_.viewport.overlays.shadow = false;
    for (int i = 0; i < 3; ++i) shell_->Frame();
  }

  View view() {
    return ViewOf(editor_.viewport, editor_.session().project(), editor_.viewport.rect);
  }
  Point MarkOf(const char* joint) {
    const PosedFigure figure = PoseNow(&editor_.session()).value();
    return *view().ToWindow(figure.CenterOf(*figure.figure().FindGroup(joint)));
  }

  const render::PictureSize size_;
  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

}  // namespace hazumi::ui
