#pragma once

#include <memory>
#include <string>

#include "engine/picture/image.h"
#include "render/contexts/osmesa_context.h"
#include "ui/shell/interface.h"

namespace hazumi::ui {

// An editor without a display: what it shows is drawn into memory, what a user would do comes from
// a script or a test.
class OffscreenShell {
 public:
  // Errors: of OsmesaContext and Interface.
  static Result<std::unique_ptr<OffscreenShell>> Create(Editor* editor, render::PictureSize size);
  ~OffscreenShell();

  // What the user does; the next frame sees it, or those after it (InputQueue).
  void MoveMouse(float x, float y);
  void PressButton(int button, bool is_down);
  void TurnWheel(float notches);
  void PressKey(int key, bool is_down);
  void Type(const std::string& utf8);

  bool has_input() { return !interface_->input().is_empty(); }

  // Lets `seconds` pass and draws a frame.
  void Frame(double seconds = 1.0 / 60.0);
  const Image& picture() const { return picture_; }
  // Draws until nothing changes any more, then writes a PNG. Errors: of writing.
  Result<Done> Capture(const std::string& path);

 private:
  OffscreenShell(Editor* editor, render::PictureSize size, render::OsmesaContext context);

  Editor* editor_;
  Image picture_;
  render::OsmesaContext context_;
  std::unique_ptr<Interface> interface_;
  double now_ = 0.0;
};

}  // namespace hazumi::ui
