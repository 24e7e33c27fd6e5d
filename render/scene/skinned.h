#pragma once

#include <memory>
#include <vector>

#include "engine/spatial/pose.h"
#include "render/scene/color.h"
#include "render/scene/skin_model.h"

namespace hazumi::render {

// A colour laid over what a bone moves; `a` is its share in the mix.
using BoneTint = SrgbColor;

// A skin in a pose: a solid that is deformed by the bodies it is bound to.
struct SkinnedFigure {
  std::shared_ptr<const SkinModel> model;
  std::vector<Pose> X_WB;       // by Skin::bones
  std::vector<BoneTint> tints;  // by Skin::bones; empty: none
  float alpha = 1.0f;           // < 1 makes it a ghost (solids.h)

  // Materials may be translucent by themselves.
  float AlphaOf(const SkinModel::Part& part) const { return alpha * part.base_color[3]; }
};

// `below` part of `over`: first that, then `over` on it.
BoneTint LaidOver(const BoneTint& over, const BoneTint& below);

}  // namespace hazumi::render
