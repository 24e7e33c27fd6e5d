#pragma once

#include <optional>
#include <vector>

#include "engine/project/json/extra_fields.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

// What a key is to the animator; it moves nothing.
enum class KeyType {
  kKeyframe,
  kBreakdown,
  kExtreme,
  kJitter,
  kMovingHold,
  kGenerated,  // written by a fill, which makes it anew when the animator's keys change
};

// Values are degrees for angles and metres for root positions; rates are per second.
struct ProjectKey {
  double frame = 0.0;
  double value = 0.0;
  std::optional<double> rate;
  Interpolation interpolation = Interpolation::kCubic;
  Easing easing = Easing::kInOut;
  std::optional<double> rate_in = {};                     // not given: `rate`
  std::optional<double> length_in = {}, length_out = {};  // of its tangents; shares, see Key
  KeyType type = KeyType::kKeyframe;
  ExtraFields extra = {};
  bool operator==(const ProjectKey&) const = default;
};

struct ProjectCurve {
  std::vector<ProjectKey> keys;  // in order of frames, no two on one frame
  ExtraFields extra;
  bool operator==(const ProjectCurve&) const = default;
};

// As the engine takes it; values times `scale` are SI, or in any other unit.
inline Keys ToKeys(const ProjectCurve& curve, double scale) {
  const auto scaled = [scale](std::optional<double> rate) {
    return rate ? std::optional(*rate * scale) : std::nullopt;
  };
  Keys keys;
  keys.reserve(curve.keys.size());
  for (const ProjectKey& key : curve.keys) {
    keys.push_back({key.frame, key.value * scale, scaled(key.rate), key.interpolation, key.easing,
                    scaled(key.rate_in), key.length_in, key.length_out});
  }
  return keys;
}

}  // namespace hazumi
