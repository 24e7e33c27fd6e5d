// Inverse kinematics for posing.

#include "engine/placement/reach.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/edit/operators/pose/posing.h"
#include "ui/edit/operators/pose/turned_hinges.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

std::optional<GroupIndex> JointNamed(const std::string& name, const Figure& figure) {
  if (const auto group = figure.FindGroup(name)) return group;
  const auto hinge = figure.FindJoint(name);
  return hinge ? std::optional(figure.joint(*hinge).group) : std::nullopt;
}

// The joint held or pinned now that turning these hinges would move, too.
std::optional<std::string> JointInTheWay(const std::vector<JointIndex>& hinges, double frame,
                                         const MotionFrame& now, const Animation& animation) {
  const Figure& figure = *animation.figure;
  const auto moves = [&](GroupIndex joint) {
    const JointIndex parent = figure.joint(figure.group(joint).first).parent;
    return parent.is_valid() && std::any_of(hinges.begin(), hinges.end(), [&](JointIndex hinge) {
             return figure.IsBeyond(parent, hinge);
           });
  };
  for (const IkHold& hold : animation.holds) {
    if (frame < hold.first_frame || frame > hold.last_frame || !moves(hold.joint)) continue;
    return "\"" + figure.group(hold.joint).name + "\" is held in this frame; remove the hold";
  }
  if (!now.pinned || !moves(*now.pinned)) return std::nullopt;
  return "\"" + figure.group(*now.pinned).name +
         "\" is pinned in this frame and the same hinges carry it; place the figure otherwise";
}

// The hinges to turn.
Result<std::vector<JointIndex>> HingesFor(GroupIndex moved, const Parameters& p, double frame,
                                          const Animation& animation,
                                          const std::set<std::string>& locked) {
  const Figure& figure = *animation.figure;
  const auto count = p.has("chain") ? std::optional(p.integer("chain")) : std::nullopt;
  if (count && *count < 0) return Refusal("chain", "must not be negative");
  const std::vector<GroupIndex> chain = ChainOf(moved, count, figure);
  if (chain.empty()) {
    return Refusal("joint", "no joint lies between the root and \"" + figure.group(moved).name +
                                "\"; move the root instead");
  }
  std::vector<JointIndex> hinges = PosedHinges(chain, frame, animation, locked);
  if (!hinges.empty()) return hinges;
  return Refusal("joint", "every joint that moves \"" + figure.group(moved).name +
                              "\" is swung by a region in this frame, or locked; end the region " +
                              "before it, or unlock one");
}

// Of a joint that is moved, what shall become of it.
struct Wanted {
  GroupIndex moved;
  Vec3 p;                 // [m]
  std::optional<Mat3> R;  // of its body; not given: any
};

// By the joint that sits on the moved body alone, if there is one and enough hinges: where it shall
// be and how its body shall be turned say all. False: it cannot be had, and `q` is as it was.
bool ReachBeyond(const Wanted& wanted, const hazumi::Pose& X_WR,
                 const std::vector<JointIndex>& hinges, const Figure& figure, VecX* q) {
  constexpr double kReached = 1e-6;  // [m], and of the turn about as much
  const auto beyond = ChildrenOf(figure.group(wanted.moved).last(), figure);
  if (beyond.size() != 1 || static_cast<int>(hinges.size()) < kFullyMovable) return false;
  const JointIndex next = figure.group(beyond[0]).first;
  VecX reached = *q;
  Reach(figure, {X_WR, next, wanted.p + *wanted.R * figure.joint(next).X_PJ.p, hinges, wanted.R},
        &reached);
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, reached, &ws);
  const BodyScratch& body = ws.body(figure.group(wanted.moved).last());
  if ((body.p - wanted.p).norm() > kReached || (body.R - *wanted.R).norm() > kReached) return false;
  *q = reached;
  return true;
}

// Takes the elbow out of the body by the hinges of the limb's first joint.
void KeepElbowOut(GroupIndex moved, const hazumi::Pose& X_WR, std::vector<JointIndex> hinges,
                  const Figure& figure, VecX* q) {
  if (!EndsLimb(moved, figure)) return;
  const std::vector<GroupIndex> limb = ChainOf(moved, std::nullopt, figure);
  std::erase_if(hinges, [&](JointIndex j) { return figure.joint(j).group != limb.back(); });
  std::sort(hinges.begin(), hinges.end());
  TurnOutOfBody({moved, limb.back()}, hinges, figure, X_WR, q);
}

// The place goes before the orientation. `own`: hinges of the moved joint that may turn. Gives the
// hinges that did.
std::vector<JointIndex> ReachWanted(const Wanted& wanted, const hazumi::Pose& X_WR,
                                    const std::vector<JointIndex>& hinges,
                                    const std::vector<JointIndex>& own, const Figure& figure,
                                    VecX* q) {
  std::vector<JointIndex> all = hinges;
  if (wanted.R) all.insert(all.end(), own.begin(), own.end());
  if (wanted.R && ReachBeyond(wanted, X_WR, all, figure, q)) return all;
  Reach(figure, {X_WR, figure.group(wanted.moved).first, wanted.p, hinges}, q);
  KeepElbowOut(wanted.moved, X_WR, hinges, figure, q);
  if (!wanted.R) return hinges;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, *q, &ws);
  TurnHinges(figure.group(wanted.moved).last(), *wanted.R,
             TurnInPlace(wanted.moved, all, figure, ws), figure, ws, q);
  return all;
}

// The same for a point of the moved body, `offset` in its frame: as the body turns on the way the
// joint's place is found again.
std::vector<JointIndex> ReachWithPoint(Wanted wanted, const Vec3& offset, const hazumi::Pose& X_WR,
                                       const std::vector<JointIndex>& hinges,
                                       const std::vector<JointIndex>& own, const Figure& figure,
                                       VecX* q) {
  constexpr int kMostTries = 40;
  constexpr double kThere = 1e-4;  // [m]
  const Vec3 point = wanted.p;
  std::vector<JointIndex> turned;
  for (int i = 0; i < kMostTries; ++i) {
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, X_WR, *q, &ws);
    const BodyScratch& body = ws.body(figure.group(wanted.moved).last());
    const Vec3 arm = body.R * offset;
    if (!turned.empty() && (body.p + arm - point).norm() < kThere) break;
    wanted.p = point - arm;
    turned = ReachWanted(wanted, X_WR, hinges, own, figure, q);
    if (offset.isZero(0.0)) break;
  }
  return turned;
}

Wanted WantedOf(GroupIndex moved, const Parameters& p, const MotionFrame& now,
                const Figure& figure) {
  Wanted wanted = {moved, Vec3(p.number("x"), p.number("y"), p.number("z")), std::nullopt};
  if (!p.yes("keep_turned", IsFoot(moved, figure))) return wanted;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  wanted.R = ws.body(figure.group(moved).last()).R;
  return wanted;
}

Result<Done> ReachFor(Session* session, const Parameters& p) {
  const Figure& figure = session->figure();
  const auto moved = JointNamed(p.text("joint"), figure);
  if (!moved) return Refusal("joint", "the figure has no joint \"" + p.text("joint") + "\"");
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Animation& animation = *session->animation();
  const double frame = session->frame();
  const std::set<std::string>& locked = session->locked_joints();
  const Result<std::vector<JointIndex>> hinges = HingesFor(*moved, p, frame, animation, locked);
  if (!hinges.ok()) return hinges.error();
  if (const auto why = JointInTheWay(hinges.value(), frame, *now.value(), animation)) {
    return Refusal("joint", *why);
  }
  VecX q = now.value()->q;
  Pose pose;
  const Vec3 offset(p.number("offset_x"), p.number("offset_y"), p.number("offset_z"));
  for (const JointIndex j : ReachWithPoint(
           WantedOf(*moved, p, *now.value(), figure), offset, now.value()->X_WR, hinges.value(),
           PosedHinges({*moved}, frame, animation, locked), figure, &q)) {
    pose.push_back({figure.joint(j).name, ShortestDegrees(q[j.value()])});
  }
  const Result<Pose> both = PoseOfSides(std::move(pose), p, session);
  if (!both.ok()) return both.error();
  return KeyPose(session, "Reach", both.value(), p.text("drag"));
}

}  // namespace

std::vector<Operator> ReachOperators() {
  constexpr const char* kOffsetHelp =
      "of the point that comes there, such as a palm, from the joint, metres in its frame";
  return {{"pose.reach",
           "Reach",
           "Turns a limb, within its limits, so that a joint comes to a place or near it; keys it.",
           {{"joint", kText, true, "a joint, e.g. a wrist", Thing::kJoint},
            {"x", kNumber, true, "where to, metres in the world"},
            {"y", kNumber, true, "metres"},
            {"z", kNumber, true, "metres"},
            {"offset_x", kNumber, false, kOffsetHelp},
            {"offset_y", kNumber, false, kOffsetHelp},
            {"offset_z", kNumber, false, kOffsetHelp},
            {"chain", kInteger, false,
             "how many joints turn; 0: all up to the root; not given: the limb"},
            {"keep_turned", kYesNo, false,
             "true: hand or foot stay turned as they are; not given: of feet"},
            kMirror,
            kDrag},
           ReachFor}};
}

}  // namespace hazumi::edit
