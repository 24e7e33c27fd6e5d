#pragma once

#include <memory>
#include <vector>

#include "render/gl/gl_name.h"
#include "render/mesh/linear_blend.h"

namespace hazumi::render {

// What the driver keeps of one skin: textures, indices and places in the textures once, and the
// posed vertices of each of its figures in the frame.
class SkinBuffers {
 public:
  SkinBuffers(const GlFunctions& gl, const std::shared_ptr<const SkinModel>& model);

  bool IsOf(const SkinModel* model) const { return model_.lock().get() == model; }
  bool IsGone() const { return model_.expired(); }

  // Forgets the poses of the last frame; buffers are used again.
  void BeginFrame() { num_posed_ = 0; }
  // Frees the buffers of poses that this frame does not have.
  void EndFrame() { poses_.resize(num_posed_); }
  // Takes the vertices of one more figure and returns its number.
  size_t AddPose(const std::vector<SkinnedVertex>& vertices);

  void BindPose(size_t pose) const { gl_->BindVertexArray(poses_[pose].array.id()); }
  // One of the model's, or white for -1, to the active texture unit.
  void BindTexture(int texture) const;
  // Of the pose that is bound.
  void DrawLevel(const SkinModel::Level& level) const;

 private:
  struct PosedBuffers {
    GlVertexArray array;
    GlBuffer vertices;
  };
  PosedBuffers MakePose() const;

  const GlFunctions* gl_;
  std::weak_ptr<const SkinModel> model_;
  GlBuffer texture_places_, indices_;
  std::optional<GlBuffer> colors_;   // if a mesh has any
  std::vector<GlTexture> textures_;  // by Skin::textures; the last one is white
  std::vector<PosedBuffers> poses_;
  size_t num_posed_ = 0;
};

}  // namespace hazumi::render
