#pragma once

#include <memory>

#include "render/gl/interface_painter.h"
#include "render/gl/scene_texture.h"
#include "ui/panels/window/editor.h"
#include "ui/shell/input_queue.h"

struct ImGuiContext;

namespace hazumi::ui {

// Draws an editor with the OpenGL 3.3 core context that is current, a window's or OSMesa's: ImGui,
// its fonts, and the pictures of scenes. Make, use and destroy it with that context current.
class Interface {
 public:
  // Fails (kFailed) when the context lacks a function.
  static Result<std::unique_ptr<Interface>> Create(render::GlProcLoader loader, Editor* editor);
  ~Interface();

  // What the user does. As long as something is left of it, draw another frame.
  InputQueue& input() { return input_; }

  // One frame of the interface: what the user did is acted upon, and the picture, of this size,
  // drawn. Ends without waiting. `seconds` since the last frame.
  void Frame(render::PictureSize size, double seconds);
  void Finish() { painter_->Finish(); }

 private:
  Interface(Editor* editor, render::InterfacePainter painter, render::SceneTexture with_shadow,
            render::SceneTexture without);
  void Restyle();
  void LoadFonts();
  void Paint(render::PictureSize size);

  Editor* editor_;
  InputQueue input_;
  ImGuiContext* context_;
  std::unique_ptr<render::InterfacePainter> painter_;
  render::SceneTexture with_shadow_, without_shadow_;
  unsigned font_texture_ = 0;
  long pictures_painted_ = -1;  // of the viewport, when it was painted last
  // What the style and the fonts were made for.
  bool is_styled_ = false, is_dark_ = false;
  double scale_ = 0.0;
  Language language_ = Language::kEnglish;
  size_t num_glyph_bytes_ = 0;  // of Editor::glyphs
};

}  // namespace hazumi::ui
