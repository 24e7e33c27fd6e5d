// What walks say alike: why they cannot go on, and what a placement did.

#include "engine/bake/walk/region_walk.h"

#include <algorithm>

#include "engine/base/text.h"

namespace hazumi {

Error RegionWalk::CannotGoOnAfter(double frame, JointIndex joint, const std::string& cause) const {
  const Figure& figure = context_.poses.figure();
  const std::string who = joint.is_valid() ? "joint \"" + figure.joint(joint).name + "\""
                                           : "root \"" + figure.root_name() + "\"";
  return {ErrorCode::kSemantics, "",
          PlaceOfRegion(joint.is_valid() ? std::optional(joint) : std::nullopt),
          "cannot go on after frame " + FormatShort(frame) + ": " + who + ": " + cause};
}

std::string RegionWalk::PlaceOfRegion(std::optional<JointIndex> joint) const {
  if (!has_regions()) return "placements";
  std::vector<int> candidates = *active();
  std::erase_if(candidates, [&](int r) {
    const auto& joints = context_.animation.regions[r].joints;
    return joint && !std::binary_search(joints.begin(), joints.end(), *joint);
  });
  if (candidates.size() != 1) return "regions";
  return "regions[" + std::to_string(candidates[0]) + "]";
}

// Curves and holds know their accelerations. Those that regions drive are given; the root's then
// follow: of its angles, of a pin that rests, of a centre of mass that falls.
MotionAcceleration RegionWalk::Completed(const FigureMotion& motion, const VecX& free,
                                         const std::optional<Vec3>& fall) {
  PoseEvaluator& poses = context_.poses;
  FigureMotion whole = motion;
  const int n = static_cast<int>(whole.q.size());
  for (int j = 0; j < n; ++j) {
    if (poses.free()[j]) whole.qdd[j] = free[j];
  }
  if (poses.free_root()) {
    RootAngles angles;
    for (int i = 0; i < kRootAngles; ++i) {
      angles.angle[i] = poses.free_root()->q[i];
      angles.rate[i] = poses.free_root()->qd[i];
      angles.acceleration[i] = free[n + i];
    }
    SetRootOrientation(angles, &whole);
  }
  const RootHold hold = poses.placement().hold();
  if (hold.coupling != RootCoupling::kPrescribed) {
    DynamicsWorkspace& ws = poses.workspace();
    whole.root.a.setZero();
    ComputePositions(poses.figure(), whole.X_WR, whole.q, &ws);
    ComputeMotion(poses.figure(), whole.root, whole.qd, whole.qdd, &ws);
    whole.root.a = hold.coupling == RootCoupling::kPinned
                       ? Vec3(-ws.body(hold.pin).a)
                       : Vec3(fall.value_or(-context_.animation.gravity * Vec3::UnitZ()) -
                              CenterOfMassAcceleration(poses.figure(), ws));
  }
  return {whole.qdd, whole.root.alpha, whole.root.a};
}

void RegionWalk::AddEvent(EventKind kind, double frame, std::optional<GroupIndex> joint) {
  context_.recorder.AddEvent(kind, frame, joint ? context_.NameOf(*joint) : "");
}

}  // namespace hazumi
