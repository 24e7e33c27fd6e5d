#pragma once

#include <memory>

#include "render/scene/skinned.h"

namespace hazumi::render {

// A tube around the z axis from 0 to `length` [m], radius 0.25, without ends. Two bones, "lower" in
// the origin and "upper" at half the length: weights change from one to the other over the middle
// fifth. The texture goes around once along u and from the top (v = 0) to the bottom (v = 1); it is
// red in its upper and green in its lower half, yellow where u > 0.5 (at y < 0).
std::shared_ptr<const Skin> TubeSkin(double length, int columns, int rows);

// The tube as it was bound: its bones without rotation.
SkinnedFigure RestingTube(const std::shared_ptr<const SkinModel>& model, double length);

}  // namespace hazumi::render
