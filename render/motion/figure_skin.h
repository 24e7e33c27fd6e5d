#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/figure/figure_bone.h"
#include "engine/figure/skin.h"
#include "render/scene/skinned.h"

namespace hazumi::render {

// A skin on a figure. Without a model there is none.
struct FigureSkin {
  std::shared_ptr<const SkinModel> model;
  std::vector<FigureBone> bones;  // by Skin::bones

  explicit operator bool() const { return model != nullptr; }
  // Where the bones are at the angles `q`; needs ComputePositions.
  std::vector<Pose> PosesIn(const Figure& figure, const VecX& q, const DynamicsWorkspace& ws) const;
};

// Finds the bones among the figure's joints: by the name of the root, a hinge, or a group of
// hinges, whose body is beyond the last one. Fails with kSemantics naming a bone it does not find.
Result<FigureSkin> PutOn(const Figure& figure, std::shared_ptr<const SkinModel> model);

// Keeps the model of the skin that was asked for last: textures are decoded and buffers filled once
// for all pictures. For one document; use it on one thread.
class SkinCache {
 public:
  // The skin on the figure; none for a null skin. Errors: MakeSkinModel's and PutOn's.
  Result<FigureSkin> On(const Figure& figure, const std::shared_ptr<const Skin>& skin);
  // What is wrong with the model that On made last, once.
  std::vector<Warning> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  std::shared_ptr<const SkinModel> model_;
  std::vector<Warning> warnings_;
};

// Returns the capsules of a figure as a skin for other programs: a mesh for each colour, in the
// pose of all angles zero with the root at the origin, each vertex bound to one body. Vertices
// that agree in place and normal are one. `columns`, a multiple of 4 and at least 8, are the facets
// around a capsule.
Skin SkinOfLinks(const Figure& figure, int columns = 16);

}  // namespace hazumi::render
