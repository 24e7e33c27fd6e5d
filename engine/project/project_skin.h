#pragma once

#include <memory>

#include "engine/figure/skin.h"

namespace hazumi {

// The figure's skin, if it has one. Shared, because nothing changes it and it is large.
struct ProjectSkin {
  std::shared_ptr<const Skin> skin;

  explicit operator bool() const { return skin != nullptr; }
  // Equal as documents.
  bool operator==(const ProjectSkin& other) const {
    return skin == other.skin || (skin && other.skin && *skin == *other.skin);
  }
};

}  // namespace hazumi
