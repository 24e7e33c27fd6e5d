#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/figure/skin.h"
#include "engine/picture/image.h"
#include "engine/spatial/types.h"

namespace hazumi::render {

// An axis-aligned box [m]. Empty when high < low.
struct Extent {
  Vec3 low = Vec3::Constant(1e30), high = Vec3::Constant(-1e30);

  bool is_empty() const { return high.x() < low.x(); }
  Vec3 center() const { return 0.5 * (low + high); }
  Vec3 half_size() const { return 0.5 * (high - low); }
  void Include(const Vec3& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
};

// A skin made ready for drawing: checked, textures decoded, sizes found. Immutable, made once for a
// skin and shared by all its pictures; what a renderer keeps for it goes when it goes.
struct SkinModel {
  enum class Surface {
    kClosed,  // only its outer side is seen
    kOpen,    // both sides are (skin_triangles.h)
    kCutout,  // so, with holes where the texture is clear
  };
  // Triangles that stand for a part, and how far from it about they may lie.
  struct Level {
    size_t first_index = 0, num_indices = 0;
    double error_m = 0.0;
  };
  // Triangles of a mesh that are drawn alike.
  struct Part {
    std::vector<Level> levels;  // all triangles first, then fewer and fewer (skin_triangles.h)
    Surface surface = Surface::kOpen;
    bool is_mirrored = false;                            // the binds turn the winding around
    std::array<float, 4> base_color;                     // linear RGB, alpha
    int texture = -1;                                    // one that has pixels, or none
    bool has_colors = false;                             // of its vertices
    std::array<float, 3> emission = {0.0f, 0.0f, 0.0f};  // linear RGB
    int emission_texture = -1;                           // as texture
  };

  std::shared_ptr<const Skin> skin;
  std::vector<Part> parts;
  std::vector<std::uint32_t> indices;  // in threes, by level; vertices counted over all meshes
  std::vector<Image> textures;         // by Skin::textures; without pixels: could not be read
  size_t num_vertices = 0;
  std::vector<std::uint32_t> seen_vertices;  // those of triangles, each once
  // By bone, in its frame: what it moves at all, and what it moves more than other bones do.
  std::vector<Extent> reach, bulk;
  std::vector<Warning> warnings;  // textures that could not be read: their colour is used alone
};

// Errors: those of CheckSkin (engine/figure/skin.h).
Result<std::shared_ptr<const SkinModel>> MakeSkinModel(std::shared_ptr<const Skin> skin);

// The weights of a vertex as drawing takes them: the sum is 1; without any weight, all is on the
// first bind.
inline std::array<float, 4> SaneWeights(const std::array<float, 4>& w) {
  const float sum = w[0] + w[1] + w[2] + w[3];
  if (!(sum > 1e-6f)) return {1.0f, 0.0f, 0.0f, 0.0f};
  return {w[0] / sum, w[1] / sum, w[2] / sum, w[3] / sum};
}

}  // namespace hazumi::render
