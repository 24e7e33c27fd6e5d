// Moves and turns the root; feet may stay where they stand.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "engine/placement/reach.h"
#include "engine/project/edits/placements.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/keys/at_frame.h"
#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/edit/operators/pose/turned_hinges.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

constexpr double kStanding = 0.005;  // a link so near to the scene stands on it [m]

// The figure at the current frame, and what says where it is.
struct Now {
  const Animation& animation;
  const MotionFrame& motion;
  DynamicsWorkspace ws;
  double frame;

  const Figure& figure() const { return *animation.figure; }
};

Result<Now> NowOf(Session* session) {
  const Result<const MotionFrame*> motion = session->FrameNow();
  if (!motion.ok()) return motion.error();
  Now now = {*session->animation(), *motion.value(), DynamicsWorkspace(session->figure()),
             session->frame()};
  ComputePositions(now.figure(), now.motion.X_WR, now.motion.q, &now.ws);
  return now;
}

bool Stands(const Link& link, const Now& now) {
  const Capsule capsule = InWorld(link, now.ws);
  const auto& scene = now.animation.scene;
  return std::any_of(scene.begin(), scene.end(), [&](const SceneObject& object) {
    return SignedDistance(capsule, object.shape).value < kStanding;
  });
}

// The joint that says where a link is, and how it is turned: the one beyond it, or its own.
GroupIndex JointOf(const Link& link, const Figure& figure) {
  const std::vector<GroupIndex> beyond = ChildrenOf(link.joint, figure);
  return beyond.size() == 1 ? beyond[0] : figure.joint(link.joint).group;
}

bool IsHeld(GroupIndex joint, const Now& now) {
  const auto& holds = now.animation.holds;
  return std::any_of(holds.begin(), holds.end(), [&](const IkHold& hold) {
    return hold.joint == joint && HasTakenOver(hold, now.frame);
  });
}

// The joints on which the figure stands, or by which it is pinned; not those that a hold keeps in
// their places anyway.
std::vector<GroupIndex> StandingJoints(const Now& now) {
  const Figure& figure = now.figure();
  std::vector<GroupIndex> joints;
  if (now.motion.pinned) joints.push_back(*now.motion.pinned);
  for (const Link& link : figure.links()) {
    if (link.joint.is_valid() && Stands(link, now)) joints.push_back(JointOf(link, figure));
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  const std::vector<GroupIndex> all = joints;
  std::erase_if(joints, [&](GroupIndex joint) {
    const JointIndex first = figure.group(joint).first;
    const bool carries_another = std::any_of(all.begin(), all.end(), [&](GroupIndex other) {
      return other != joint && figure.IsBeyond(figure.group(other).first, first);
    });
    return carries_another || IsHeld(joint, now);
  });
  return joints;
}

// Turns what is in its place as it was turned, although what carries it is not: the toes, or a foot
// on which no other joint sits. The hinges, if there was anything to turn.
std::vector<JointIndex> KeepTurned(GroupIndex joint, const hazumi::Pose& X_WR, const Now& now,
                                   const std::vector<JointIndex>& may_turn, VecX* q) {
  constexpr double kTurned = 1e-6;
  const Figure& figure = now.figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, *q, &ws);
  const JointIndex last = figure.group(joint).last();
  if ((ws.body(last).R - now.ws.body(last).R).norm() < kTurned) return {};
  std::vector<JointIndex> hinges = TurnInPlace(joint, may_turn, figure, ws);
  TurnHinges(last, now.ws.body(last).R, hinges, figure, ws, q);
  return hinges;
}

// Angles with which the standing joints stay where they are while the root goes to `X_WR`.
// `keep_turned`: and turned as they are.
Result<Pose> Standing(const hazumi::Pose& X_WR, const Now& now, bool keep_turned,
                      const Session& session) {
  const Figure& figure = now.figure();
  VecX q = now.motion.q;
  Pose pose;
  for (const GroupIndex joint : StandingJoints(now)) {
    std::vector<JointIndex> hinges = PosedHinges(ChainOf(joint, std::nullopt, figure), now.frame,
                                                 now.animation, session.locked_joints());
    if (hinges.empty()) {
      return Refusal("", "every joint that could keep \"" + figure.group(joint).name +
                             "\" in its place is swung by a region in this frame, or locked");
    }
    const JointIndex first = figure.group(joint).first;
    ReachProblem problem = {X_WR, first, now.ws.body(first).p, hinges, std::nullopt};
    if (keep_turned && static_cast<int>(hinges.size()) >= kFullyMovable) {
      problem.orientation = now.ws.body(figure.joint(first).parent).R;
    }
    Reach(figure, problem, &q);
    if (keep_turned) {
      const auto own =
          KeepTurned(joint, X_WR, now,
                     PosedHinges({joint}, now.frame, now.animation, session.locked_joints()), &q);
      hinges.insert(hinges.end(), own.begin(), own.end());
    }
    for (const JointIndex j : hinges) {
      pose.push_back({figure.joint(j).name, WithoutRoundOff(q[j.value()] / kDegree)});
    }
  }
  return pose;
}

bool KeepsTurned(const Parameters& p) { return p.yes("keep_turned", true); }

Error InFlight() {
  return Refusal("",
                 "the figure is in flight in this frame: how it took off says where it is; "
                 "move the root on the first frame of the placement");
}

Result<Done> MoveRoot(Session* session, const Parameters& p) {
  const Result<Now> now = NowOf(session);
  if (!now.ok()) return now.error();
  const Vec3 to(p.number("x"), p.number("y"), p.number("z"));
  const bool is_placed = IsPlaced(now.value().animation, now.value().frame);
  const bool feet_stay = p.yes("feet_stay", true);
  Pose pose;
  if (feet_stay) {
    Result<Pose> standing =
        Standing({now.value().motion.X_WR.R, to}, now.value(), KeepsTurned(p), *session);
    if (!standing.ok()) return standing.error();
    pose = std::move(standing).value();
  }
  if (is_placed && now.value().motion.pinned && !feet_stay) {
    const JointGroup& pinned = session->figure().group(*now.value().motion.pinned);
    return Refusal("feet_stay", "\"" + pinned.name +
                                    "\" is pinned in this frame and stays where it is; move the "
                                    "root on the first frame of the placement");
  }
  if (is_placed && pose.empty()) return InFlight();
  for (int i = 0; i < 3 && !is_placed; ++i) pose.push_back({kRootCurveNames[i], to[i]});
  return KeyPose(session, "Move root", pose, p.text("drag"));
}

Result<Done> TurnRoot(Session* session, const Parameters& p) {
  const Result<Now> now = NowOf(session);
  if (!now.ok()) return now.error();
  const Vec3 axis(p.number("x"), p.number("y"), p.number("z"));
  if (axis.norm() < 1e-9) return Refusal("x", "x, y and z are all 0: they give no axis");
  for (const DynamicsRegion& region : now.value().animation.regions) {
    if (!region.root || !HasTakenOver(region, now.value().frame)) continue;
    return Refusal("", "the region \"" + region.name + "\" turns the root in this frame");
  }
  hazumi::Pose X_WR = now.value().motion.X_WR;
  X_WR.R = Eigen::AngleAxisd(p.number("by") * kDegree, axis.normalized()) * X_WR.R;
  Pose pose;
  if (p.yes("feet_stay")) {
    Result<Pose> standing = Standing(X_WR, now.value(), KeepsTurned(p), *session);
    if (!standing.ok()) return standing.error();
    pose = std::move(standing).value();
  }
  const auto values = RootValues(X_WR, session->project().root, session->frame());
  for (int i = kRootAngleZ; i < kNumRootCurves; ++i) {
    pose.push_back({kRootCurveNames[i], WithoutRoundOff(values[i])});
  }
  return KeyPose(session, "Turn root", pose, p.text("drag"));
}

// How far the figure must be lifted until nothing of it is inside the scene [m].
double LiftOut(const Now& now) {
  constexpr int kMost = 1000;
  constexpr double kLeast = 1e-6;  // a normal that points sideways gives no height
  double lift = 0.0;
  for (int i = 0; i < kMost; ++i) {
    const auto contact =
        NearestContact(now.figure(), now.animation.scene, now.ws, {0.0, 0.0, lift});
    if (!contact || contact->clearance >= 0.0) break;
    lift += std::max(-contact->clearance, kLeast);
  }
  return lift;
}

Result<Done> SetRootToGround(Session* session, const Parameters&) {
  constexpr double kFar = 1000.0;  // [m]
  const Result<Now> now = NowOf(session);
  if (!now.ok()) return now.error();
  if (IsPlaced(now.value().animation, now.value().frame)) {
    return Refusal("",
                   "a pin or gravity says where the figure is in this frame; end its span "
                   "before, or go to its first frame");
  }
  const double lift = LiftOut(now.value());
  const auto touch = FirstTouchOfFigure(now.value().figure(), now.value().animation.scene,
                                        now.value().ws, {0.0, 0.0, lift}, {0.0, 0.0, -kFar});
  if (!touch) return Refusal("", "there is nothing under the figure; add a ground to the scene");
  const double z = now.value().motion.X_WR.p.z() + lift - *touch * kFar;
  return KeyPose(session, "Put on the ground", {{kRootCurveNames[kRootZ], WithoutRoundOff(z)}});
}

}  // namespace

std::vector<Operator> RootOperators() {
  const ParameterInfo keep_turned = {"keep_turned", kYesNo, false,
                                     "false: feet that stay in their places may roll",
                                     kOnUnlessGiven};
  return {{"root.move",
           "Move root",
           "Moves the root at the current frame; legs bend so that feet stay where they stand.",
           {{"x", kNumber, true, "where to, metres in the world"},
            {"y", kNumber, true, "metres"},
            {"z", kNumber, true, "metres"},
            {"feet_stay", kYesNo, false, "false: the whole figure moves", kOnUnlessGiven},
            keep_turned,
            kDrag},
           MoveRoot},
          {"root.turn",
           "Turn root",
           "Turns the whole figure at the current frame, or the root above feet that stay.",
           {{"x", kNumber, true, "the axis in the world"},
            {"y", kNumber, true, "of the axis"},
            {"z", kNumber, true, "of the axis"},
            {"by", kNumber, true, "degrees"},
            {"feet_stay", kYesNo, false, "true: legs bend so that feet stay where they stand"},
            keep_turned,
            kDrag},
           TurnRoot},
          {"root.to_ground",
           "Put on the ground",
           "Keys the root's height so that the figure just touches what is under it.",
           {},
           SetRootToGround}};
}

}  // namespace hazumi::edit
