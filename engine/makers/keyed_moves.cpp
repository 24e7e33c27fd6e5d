#include "engine/makers/keyed_moves.h"

#include <algorithm>
#include <cmath>

#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"

namespace hazumi::makers {

std::optional<Error> CheckBody(const std::vector<std::string>& human_hinges,
                               const std::string& whose, const Figure& figure) {
  const FigureBody body(figure);
  const auto missing =
      std::find_if(human_hinges.begin(), human_hinges.end(),
                   [&](const std::string& hinge) { return body.HingesFor(hinge).empty(); });
  if (missing == human_hinges.end()) return std::nullopt;
  if (body.HasFourLegs()) {
    return Refusal("", "the figure stands on four legs; a " + whose + " is made for two");
  }
  return Refusal("", "no hinge of the figure does what \"" + *missing +
                         "\" of the human does, which a " + whose +
                         " needs; import it again with the hinges of a body");
}

std::string StandingJoint(const FigureBody& body, BodySide side, const Figure& figure) {
  for (const BodyRole role : {BodyRole::kToe, BodyRole::kFoot, BodyRole::kShin}) {
    if (const auto joint = body.Find(role, side)) return figure.group(*joint).name;
  }
  return "";
}

std::optional<Error> CheckFreeOfRegions(int first, int last, const std::string& instead,
                                        const Project& project) {
  for (const ProjectRegion& region : project.regions) {
    if (region.first_frame >= last || region.last_frame <= first) continue;
    return Refusal("", "the region \"" + region.name + "\" moves joints in frames " +
                           std::to_string(region.first_frame) + " to " +
                           std::to_string(region.last_frame) + "; " + instead);
  }
  for (const ProjectFill& fill : project.fills) {
    if (fill.first_frame >= last || fill.last_frame <= first) continue;
    return Refusal("", "the fill \"" + fill.name + "\" makes keys in frames " +
                           std::to_string(fill.first_frame) + " to " +
                           std::to_string(fill.last_frame) + "; " + instead);
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
