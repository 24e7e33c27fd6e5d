#include "engine/bake/walk/own_pairs.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi {

namespace {

constexpr double kNotice = 1e-4;  // [m]

bool HasLink(const Figure& figure, JointIndex joint) {
  return std::any_of(figure.links().begin(), figure.links().end(),
                     [&](const Link& link) { return link.joint == joint; });
}

// The nearest joint towards the root that carries links; the root, which may carry none.
JointIndex HangsOn(const Figure& figure, JointIndex joint) {
  do {
    joint = figure.joint(joint).parent;
  } while (joint.is_valid() && !HasLink(figure, joint));
  return joint;
}

double GapOf(const LinkPair& pair, const Figure& figure, const DynamicsWorkspace& ws) {
  return SignedDistance(InWorld(figure.links()[pair.a], ws), InWorld(figure.links()[pair.b], ws))
      .value;
}

}  // namespace

std::vector<LinkPair> PairsApart(const Figure& figure) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, Pose(), VecX::Zero(figure.num_joints()), &ws);
  std::vector<LinkPair> pairs;
  const auto count = static_cast<int>(figure.links().size());
  const auto joint_of = [&](int link) { return figure.links()[link].joint; };
  const auto hangs_on = [&](int link, int on) {
    return joint_of(link).is_valid() && HangsOn(figure, joint_of(link)) == joint_of(on);
  };
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (joint_of(a) == joint_of(b) || hangs_on(a, b) || hangs_on(b, a)) continue;
      if (GapOf({a, b}, figure, ws) > 0.0) pairs.push_back({a, b});
    }
  }
  return pairs;
}

std::optional<std::string> TellOfOverlap(const std::vector<LinkPair>& pairs, const Figure& figure,
                                         const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  const LinkPair* deepest = nullptr;
  double depth = kNotice;
  for (const LinkPair& pair : pairs) {
    const double own = -GapOf(pair, figure, *ws);
    if (own <= depth) continue;
    depth = own;
    deepest = &pair;
  }
  if (!deepest) return std::nullopt;
  return "\"" + figure.links()[deepest->a].name + "\" and \"" + figure.links()[deepest->b].name +
         "\" begin " + FormatShort(1000.0 * depth) + " mm inside each other in frame " +
         FormatShort(motion.frame) +
         ": they are pushed apart slowly; move one of them in that frame";
}

}  // namespace hazumi
