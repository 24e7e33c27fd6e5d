#pragma once

#include <memory>
#include <optional>

#include "engine/figure/skin.h"

namespace hazumi {

// Skins that come with the program, so that files need only name them.
enum class ShippedSkin { kHuman };  // for assets/figures/human.json

// Made when it is first asked for, and never again.
const std::shared_ptr<const Skin>& MeshesOf(ShippedSkin skin);

// The figure's skin, if it has one. Shared, because nothing changes it and it is large.
struct ProjectSkin {
  std::optional<ShippedSkin> shipped = {};
  std::shared_ptr<const Skin> skin;  // the project's own, if none is shipped

  explicit operator bool() const { return shipped || skin; }
  // Null: none.
  std::shared_ptr<const Skin> meshes() const { return shipped ? MeshesOf(*shipped) : skin; }
  // Equal as documents.
  bool operator==(const ProjectSkin& other) const {
    return shipped == other.shipped &&
           (skin == other.skin || (skin && other.skin && *skin == *other.skin));
  }
};

// What a thing that is held looks like: meshes bound to one bone, its own; null: its shape. They
// are stretched to fill the box around the shape.
struct ProjectMesh {
  std::shared_ptr<const Skin> skin;

  explicit operator bool() const { return skin != nullptr; }
  // Equal as documents.
  bool operator==(const ProjectMesh& other) const {
    return skin == other.skin || (skin && other.skin && *skin == *other.skin);
  }
};

}  // namespace hazumi
