#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/collision/shapes.h"
#include "engine/project/item_id.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::ui {

struct Ball {
  Vec3 center = Vec3::Zero();  // in the world [m]
  double radius = 0.0;
};

// A box of the scene or a held object, where it is seen.
struct Solid {
  ItemId id;
  std::string name;
  std::variant<Box, Ball> shape;
  bool is_held_object = false;

  Vec3 center() const;
};

// All that can be clicked on but the figure, at the frame of `figure`, which is shown.
std::vector<Solid> SolidsOf(edit::Session* session, const PosedFigure& figure);
// The one with this id, or null.
const Solid* FindSolid(ItemId id, const std::vector<Solid>& solids);

}  // namespace hazumi::ui
