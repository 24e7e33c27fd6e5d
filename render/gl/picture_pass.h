#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/gl/shader_program.h"
#include "render/gl/vertex_stream.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// Draws the pictures of a scene. A texture is kept as long as its picture is shown.
class PicturePass {
 public:
  PicturePass() = default;
  explicit PicturePass(const GlFunctions& gl) : gl_(&gl) {}

  void Upload(const Scene& scene, const Mat4& clip_from_world, double aspect);
  bool has_background() const;
  // Over what surrounds the scene, before what stands in it.
  void DrawBackground();
  void DrawPlanes();

 private:
  struct Shown {
    std::shared_ptr<const Image> image;
    GlTexture texture;
    VertexStream corners;
    bool is_background = false;
    float opacity = 1.0f;
  };
  Shown Taken(const std::shared_ptr<const Image>& image);
  void Draw(const Shown& shown);

  const GlFunctions* gl_ = nullptr;
  std::optional<ShaderProgram> program_;  // compiled when first needed
  std::vector<Shown> shown_;
};

}  // namespace hazumi::render
