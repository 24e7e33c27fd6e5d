#include "engine/bake/walk/own_pairs.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi {

namespace {

constexpr double kNotice = 1e-4;  // [m]

// By link: the nearest joint towards the root that carries links; the root, which may carry none.
// Of a link of the root: none.
std::vector<std::optional<JointIndex>> HangingOn(const Figure& figure) {
  std::vector<char> has_links(figure.num_joints(), 0);
  for (const Link& link : figure.links()) {
    if (link.joint.is_valid()) has_links[link.joint.value()] = 1;
  }
  std::vector<std::optional<JointIndex>> hanging;
  for (const Link& link : figure.links()) {
    hanging.emplace_back();
    if (!link.joint.is_valid()) continue;
    JointIndex on = figure.joint(link.joint).parent;
    while (on.is_valid() && !has_links[on.value()]) on = figure.joint(on).parent;
    hanging.back() = on;
  }
  return hanging;
}

double GapOf(const LinkPair& pair, const Figure& figure, const DynamicsWorkspace& ws) {
  return SignedDistance(InWorld(figure.links()[pair.a], ws), InWorld(figure.links()[pair.b], ws))
      .value;
}

}  // namespace

std::vector<LinkPair> PairsApart(const Figure& figure, bool with_touching) {
  constexpr double kTouches = 1e-6;  // [m]
  const double least = with_touching ? -kTouches : 0.0;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, Pose(), VecX::Zero(figure.num_joints()), &ws);
  std::vector<LinkPair> pairs;
  const auto count = static_cast<int>(figure.links().size());
  const auto joint_of = [&](int link) { return figure.links()[link].joint; };
  const std::vector<std::optional<JointIndex>> hanging = HangingOn(figure);
  const auto hangs_on = [&](int link, int on) { return hanging[link] == joint_of(on); };
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (joint_of(a) == joint_of(b) || hangs_on(a, b) || hangs_on(b, a)) continue;
      if (GapOf({a, b}, figure, ws) > least) pairs.push_back({a, b});
    }
  }
  return pairs;
}

std::optional<Overlap> DeepestOverlap(const std::vector<LinkPair>& pairs, const Figure& figure,
                                      const DynamicsWorkspace& ws) {
  std::optional<Overlap> deepest;
  for (const LinkPair& pair : pairs) {
    const double depth = -GapOf(pair, figure, ws);
    if (depth > (deepest ? deepest->depth : 0.0)) deepest = {pair, depth};
  }
  return deepest;
}

std::optional<std::string> TellOfOverlap(const std::vector<LinkPair>& pairs, const Figure& figure,
                                         const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  const std::optional<Overlap> deepest = DeepestOverlap(pairs, figure, *ws);
  if (!deepest || deepest->depth <= kNotice) return std::nullopt;
  return "\"" + figure.links()[deepest->pair.a].name + "\" and \"" +
         figure.links()[deepest->pair.b].name + "\" begin " + FormatShort(1000.0 * deepest->depth) +
         " mm inside each other in frame " + FormatShort(motion.frame) +
         ": they are pushed apart slowly; move one of them in that frame";
}

}  // namespace hazumi
