#pragma once

#include <memory>

#include "render/gl/renderer.h"

namespace hazumi::render {

// A scene drawn into a texture, for an interface to show. Use it on the thread and with the context
// that made it.
class SceneTexture {
 public:
  // Fails (kFailed) when the context lacks a function.
  static Result<SceneTexture> Create(GlProcLoader loader, const RendererOptions& options);
  ~SceneTexture();
  SceneTexture(SceneTexture&&) noexcept;
  SceneTexture& operator=(SceneTexture&&) noexcept;

  // The picture, bottom row first as GL has it. Errors: of Renderer::Draw.
  Result<unsigned> Draw(const Scene& scene, PictureSize size);

 private:
  struct State;
  explicit SceneTexture(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hazumi::render
