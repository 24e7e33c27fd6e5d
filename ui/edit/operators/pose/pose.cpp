// Poses at the current frame.

#include <algorithm>

#include "engine/project/edits/curves.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/posing.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

void KeyAngle(double frame, double angle, ProjectCurve* curve) {
  ProjectKey key = KeyToChange(frame, *curve);
  key.value = angle;
  PutKey(key, curve);
}

// To an angle or by one; the joint's limits hold.
Result<Done> RotateJoint(Session* session, const Parameters& p) {
  const std::string hinge = p.text("joint");
  double angle = p.number("to");
  if (!p.has("to")) {
    const Result<double> now = session->ValueNow(hinge);
    if (!now.ok()) return now.error();
    angle = now.value() + p.number("by");
  }
  if (p.yes("within_limits", true)) angle = WithinLimits(hinge, angle, session->figure());
  const Result<Pose> pose = PoseOfSides({{hinge, angle}}, p, session);
  if (!pose.ok()) return pose.error();
  return KeyPose(session, "Rotate joint", pose.value(), p.text("drag"));
}

Result<Done> ClearPose(Session* session, const Parameters&) {
  Pose rest;
  for (const std::string& name : PosedCurves(*session)) {
    const std::optional<int> of_root = RootCurveNamed(name);
    if (of_root && *of_root < kRootAngleZ) continue;  // where it is is no pose
    const auto hinge = session->figure().FindJoint(name);
    rest.push_back({name, hinge ? ShortestDegrees(session->figure().joint(*hinge).rest) : 0.0});
  }
  return KeyPose(session, "Clear pose", rest);
}

Result<Done> CopyPose(Session* session, const Parameters&) {
  Pose pose;
  for (const std::string& name : PosedCurves(*session)) {
    const Result<double> angle = session->ValueNow(name);
    if (!angle.ok()) return angle.error();
    pose.push_back({name, angle.value()});
  }
  session->set_clipboard(std::move(pose));
  return Done();
}

Result<Done> PastePose(Session* session, const Parameters& p) {
  if (session->clipboard().empty()) return Refusal("", "no pose has been copied");
  if (!p.yes("flipped")) return KeyPose(session, "Paste pose", session->clipboard());
  const Result<Pose> flipped = Flipped(session->clipboard(), session);
  if (!flipped.ok()) return flipped.error();
  return KeyPose(session, "Paste pose flipped", flipped.value());
}

}  // namespace

std::vector<std::string> PosedCurves(const Session& session) {
  if (!session.selected_joints().empty()) {
    return CurvesOf(session.selected_joints(), session.figure());
  }
  std::vector<std::string> all;
  for (const Joint& joint : session.figure().joints()) all.push_back(joint.name);
  return all;
}

double WithinLimits(const std::string& curve, double value, const Figure& figure) {
  const std::optional<JointIndex> hinge = figure.FindJoint(curve);
  if (!hinge) return value;
  const Joint& joint = figure.joint(*hinge);
  return std::clamp(value, ShortestDegrees(joint.lower), ShortestDegrees(joint.upper));
}

Result<Done> KeyPose(Session* session, const std::string& label, const Pose& pose,
                     const std::string& drag) {
  const std::set<std::string>& locked = session->locked_joints();
  const auto is_locked = [&](const Named<double>& angle) {
    return locked.contains(RootCurveNamed(angle.name) ? session->figure().root_name() : angle.name);
  };
  if (!pose.empty() && std::all_of(pose.begin(), pose.end(), is_locked)) {
    return Refusal("joint", "\"" + pose[0].name + "\" is locked; unlock it in the outliner");
  }
  return session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        for (const Named<double>& angle : pose) {
          if (is_locked(angle)) continue;
          const Result<ProjectCurve*> curve = CurveNamed(angle.name, session->figure(), project);
          if (!curve.ok()) return curve.error();
          KeyAngle(session->frame(), angle.value, curve.value());
        }
        return Done();
      },
      drag);
}

std::vector<Operator> PoseOperators() {
  return {
      {"pose.rotate",
       "Rotate joint",
       "Keys an angle at the current frame.",
       {{"joint", kText, true, "a hinge", Thing::kHinge},
        {"to", kNumber, false, "the angle in degrees"},
        {"by", kNumber, false, "what is added to the present angle"},
        {"within_limits", kYesNo, false, "false: beyond the joint's limits too", kOnUnlessGiven},
        kMirror,
        kDrag},
       RotateJoint},
      {"pose.clear",
       "Clear pose",
       "Keys the rest angles of the selected joints, or of all. The root is turned upright.",
       {},
       ClearPose},
      {"pose.copy",
       "Copy pose",
       "Copies the angles of the selected joints, or of all.",
       {},
       CopyPose},
      {"pose.paste",
       "Paste pose",
       "Keys the copied angles at the current frame.",
       {{"flipped", kYesNo, false, "true: left for right"}},
       PastePose}};
}

}  // namespace hazumi::edit
