#include "engine/makers/keyed_moves.h"

#include <algorithm>
#include <cmath>

#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"

namespace hazumi::makers {

std::optional<Error> CheckHinges(const std::vector<std::string>& names, const std::string& whose,
                                 const Figure& figure) {
  const auto missing = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return !figure.FindJoint(name).has_value();
  });
  if (missing == names.end()) return std::nullopt;
  return Refusal("", "the figure has no hinge \"" + *missing + "\": a " + whose +
                         "'s poses are those of the human that comes with Hazumi");
}

std::optional<Error> CheckFreeOfRegions(int first, int last, const std::string& instead,
                                        const Project& project) {
  for (const ProjectRegion& region : project.regions) {
    if (region.first_frame >= last || region.last_frame <= first) continue;
    return Refusal("", "the region \"" + region.name + "\" moves joints in frames " +
                           std::to_string(region.first_frame) + " to " +
                           std::to_string(region.last_frame) + "; " + instead);
  }
  return std::nullopt;
}

void KeyMove(int frame, double value, std::optional<double> rate, ProjectCurve* curve) {
  ProjectKey key;
  key.frame = frame;
  key.value = WithoutRoundOff(value);
  if (rate) key.rate = WithoutRoundOff(*rate);
  PutKey(key, curve);
}

int FramesOf(double seconds, int least, const Animation& animation) {
  return std::max(least, static_cast<int>(std::lround(animation.rate.FrameAt(seconds))));
}

}  // namespace hazumi::makers
