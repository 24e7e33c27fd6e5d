// Turns a limb about its own axis: hand or foot stay where they are, elbow or knee go round.

#include "engine/dynamics/kinematics.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/edit/operators/pose/posing.h"
#include "ui/edit/operators/pose/turned_hinges.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<Limb> LimbTo(const std::string& joint, const Figure& figure) {
  const auto end = figure.FindGroup(joint);
  if (!end) return Refusal("joint", "the figure has no joint \"" + joint + "\"");
  if (EndsLimb(*end, figure)) return Limb{*end, ChainOf(*end, std::nullopt, figure).back()};
  return Refusal("joint", "no limb of two joints carries \"" + joint + "\"; name a hand or a foot");
}

std::vector<JointIndex> HingesThatTurn(GroupIndex joint, Session* session) {
  return PosedHinges({joint}, session->frame(), *session->animation(), session->locked_joints());
}

// Of the joints between the limb's first one and its end, and of the end.
std::vector<JointIndex> HingesBeyond(const Limb& limb, Session* session) {
  std::vector<JointIndex> hinges = HingesThatTurn(limb.end, session);
  for (const GroupIndex joint : ChainOf(limb.end, std::nullopt, session->figure())) {
    if (joint == limb.first) continue;
    for (const JointIndex j : HingesThatTurn(joint, session)) hinges.push_back(j);
  }
  return hinges;
}

// The angles of the hinges that turned.
Result<Pose> Swivelled(const Limb& limb, double angle, Session* session) {
  const Figure& figure = session->figure();
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const hazumi::Pose X_WR = now.value()->X_WR;
  VecX q = now.value()->q;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, q, &ws);
  std::vector<JointIndex> hinges = HingesThatTurn(limb.first, session);
  if (hinges.empty() || (angle != 0.0 && TurnLimb(angle, limb, hinges, figure, ws, &q) == 0.0)) {
    return Refusal("joint", "\"" + figure.group(limb.first).name +
                                "\" cannot turn the limb that way: a limit, a lock or a region is "
                                "in the way, or it has too few hinges");
  }
  const JointIndex end = figure.group(limb.end).last();
  const Mat3 R_end = ws.body(end).R;
  ComputePositions(figure, X_WR, q, &ws);
  const auto last = TurnInPlace(limb.end, HingesBeyond(limb, session), figure, ws);
  TurnHinges(end, R_end, last, figure, ws, &q);
  hinges.insert(hinges.end(), last.begin(), last.end());
  Pose pose;
  for (const JointIndex j : hinges) {
    pose.push_back({figure.joint(j).name, WithoutRoundOff(q[j.value()] / kDegree)});
  }
  return pose;
}

Result<Done> Swivel(Session* session, const Parameters& p) {
  const Result<Limb> limb = LimbTo(p.text("joint"), session->figure());
  if (!limb.ok()) return limb.error();
  Result<Pose> pose = Swivelled(limb.value(), p.number("angle") * kDegree, session);
  if (pose.ok()) pose = PoseOfSides(std::move(pose).value(), p, session);
  if (!pose.ok()) return pose.error();
  return KeyPose(session, "Swivel limb", pose.value(), p.text("drag"));
}

}  // namespace

std::vector<Operator> SwivelOperators() {
  return {{"pose.swivel",
           "Swivel limb",
           "Turns a limb about the line to its hand or foot, which stays, and is turned as it was.",
           {{"joint", kText, true, "what stays: a wrist or an ankle", Thing::kJoint},
            {"angle", kNumber, true, "degrees about the line from the first joint to it"},
            kMirror,
            kDrag},
           Swivel}};
}

}  // namespace hazumi::edit
