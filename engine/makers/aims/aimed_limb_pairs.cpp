// Planes and boxes that a limb stays out of.

#include <algorithm>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/aimed_limb.h"

namespace hazumi::makers {

// Links of the limb and what is within its reach. What they are in, or touch, as it begins is left
// out.
void AimedLimb::TakePairs() {
  constexpr double kApart = 0.002;  // [m]
  const solve::ChainPose pose =
      solve::PoseOfChain(problem_.chain, 1, solve::TurnsOf(problem_, start_.col(1)));
  for (const Link& link : figure_.links()) {
    const auto at = std::find(hinges_.path.begin(), hinges_.path.end(), link.joint);
    if (at == hinges_.path.end()) continue;
    const int k = static_cast<int>(at - hinges_.path.begin());
    const solve::ChainPose::Body& body = pose.bodies[static_cast<size_t>(k)];
    const Capsule now = {body.o + body.W * link.capsule.a, body.o + body.W * link.capsule.b,
                         link.capsule.radius};
    for (const SceneObject& object : animation_.scene) {
      if (SignedDistance(now, object.shape).value < kApart) continue;
      problem_.pairs.push_back({k, link.capsule, object.shape});
    }
  }
}

double AimedLimb::DepthAt(int t, const VecX& angles) const {
  const solve::ChainPose pose =
      solve::PoseOfChain(problem_.chain, t, solve::TurnsOf(problem_, angles));
  double depth = 0.0;
  for (const solve::AimPair& pair : problem_.pairs) {
    const solve::ChainPose::Body& body = pose.bodies[static_cast<size_t>(pair.hinge)];
    const Capsule now = {body.o + body.W * pair.capsule.a, body.o + body.W * pair.capsule.b,
                         pair.capsule.radius};
    depth = std::max(depth, -SignedDistance(now, pair.obstacle).value);
  }
  return depth;
}

double AimedLimb::DepthIn(const Motion& motion) const {
  double depth = 0.0;
  DynamicsWorkspace ws(figure_);
  for (int f = first_ + 1; f <= last_ && !problem_.pairs.empty(); ++f) {
    const MotionLimit& at = ArrivalAt(f, motion);
    ComputePositions(figure_, at.X_WR, at.q, &ws);
    for (const solve::AimPair& pair : problem_.pairs) {
      const BodyScratch& body = ws.body(hinges_.path[static_cast<size_t>(pair.hinge)]);
      const Capsule now = {body.p + body.R * pair.capsule.a, body.p + body.R * pair.capsule.b,
                           pair.capsule.radius};
      depth = std::max(depth, -SignedDistance(now, pair.obstacle).value);
    }
  }
  return depth;
}

}  // namespace hazumi::makers
