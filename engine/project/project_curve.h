#pragma once

#include <optional>
#include <vector>

#include "engine/project/json/extra_fields.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

// Values are degrees for angles and metres for root positions; rates are per second.
struct ProjectKey {
  double frame = 0.0;
  double value = 0.0;
  std::optional<double> rate;
  Interpolation interpolation = Interpolation::kCubic;
  ExtraFields extra;
  bool operator==(const ProjectKey&) const = default;
};

struct ProjectCurve {
  std::vector<ProjectKey> keys;  // in order of frames, no two on one frame
  ExtraFields extra;
  bool operator==(const ProjectCurve&) const = default;
};

}  // namespace hazumi
