#include "engine/project/project_curve.h"

namespace hazumi {

Keys ToKeys(const ProjectCurve& curve, double scale) {
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
