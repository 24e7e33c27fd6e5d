// Fills: keys that the program writes between those of the animator.

#include <algorithm>
#include <cmath>

#include "engine/makers/fills/fill_effort.h"
#include "engine/makers/fills/fills.h"
#include "engine/project/checks/joint_names.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kFill = {"fill", kText, true, "the fill's name", Thing::kFill};

// The selected joints; none: all.
std::vector<JointRef> LikelyJoints(const Session& session) {
  std::vector<JointRef> joints;
  for (const std::string& name : SelectedNames(session)) joints.push_back({name, false, {}});
  if (joints.empty()) joints.push_back({NameOfRoot(session.figure()), true, {}});
  return joints;
}

// Widens the span to a frame.
void Include(double frame, bool* any, ProjectFill* fill) {
  const int below = static_cast<int>(std::floor(frame)), above = static_cast<int>(std::ceil(frame));
  fill->first_frame = *any ? std::min(fill->first_frame, below) : below;
  fill->last_frame = *any ? std::max(fill->last_frame, above) : above;
  *any = true;
}

// Sets the frames from the first to the last selected key; with fewer than two, to those of the
// joints' keys.
void ChooseFrames(const Session& session, ProjectFill* fill) {
  bool any = false;
  for (const auto& [curve, frames] : session.selected_keys()) {
    for (const double frame : frames) Include(frame, &any, fill);
  }
  if (any && fill->first_frame < fill->last_frame) return;
  any = false;
  const Project& project = session.project();
  const std::vector<bool> hinges = JointsOf(fill->joints, session.figure());
  for (const auto& joint : project.joints) {
    const auto j = session.figure().FindJoint(joint.name);
    if (!j || !hinges[static_cast<size_t>(j->value())]) continue;
    for (const ProjectKey& key : joint.value.keys) Include(key.frame, &any, fill);
  }
  if (NameRoot(fill->joints, session.figure())) {
    for (const ProjectCurve& curve : project.root.curves) {
      for (const ProjectKey& key : curve.keys) Include(key.frame, &any, fill);
    }
  }
}

// Measures how far a fill moves joints, and but for drags the torques before and after.
Result<Done> Measure(Session* session, size_t index, bool is_drag, Result<Done> done) {
  if (!done.ok() || index >= session->fill_reports().size()) return done;
  const makers::FillReport& report = session->fill_reports()[index];
  session->Measured("keys", report.keys);
  session->Measured("moved_cm", 100.0 * report.farthest);
  session->Measured("moved_at", report.frame);
  session->Measured("stepped", static_cast<double>(report.stepped.size()));
  session->Measured("unfilled", static_cast<double>(report.unfilled.size()));
  if (is_drag) return done;
  Project without = session->project();
  const ProjectFill fill = without.fills[index];
  makers::RemoveGeneratedKeys(fill, session->figure(), &without);
  const Result<double> before = makers::TorqueIn(fill, without);
  const Result<double> after = makers::TorqueIn(fill, session->project());
  if (!before.ok() || !after.ok()) return done;
  session->Measured("torque_before_n_m", before.value());
  session->Measured("torque_n_m", after.value());
  return done;
}

Result<Done> AddFill(Session* session, const Parameters& p) {
  size_t index = 0;
  Result<Done> done = session->Edit("Fill between keys", [&](Project* project) -> Result<Done> {
    ProjectFill fill;
    fill.name = "fill";
    fill.joints = LikelyJoints(*session);
    if (p.has("joints")) {
      fill.joints.clear();
      if (Result<Done> set = SetFields(p, &fill); !set.ok()) return set;
      Resolve(session->figure(), &fill.joints);
    }
    ChooseFrames(*session, &fill);
    if (Result<Done> set = SetFields(p, &fill); !set.ok()) return set;
    Resolve(session->figure(), &fill.joints);
    if (fill.first_frame >= fill.last_frame) {
      return Refusal("joints", "they have fewer than two keys to fill between; set some");
    }
    fill.name = FreeName(fill.name, project->fills);
    project->fills.push_back(std::move(fill));
    index = project->fills.size() - 1;
    return Done();
  });
  return Measure(session, index, false, std::move(done));
}

Result<Done> SetFill(Session* session, const Parameters& p) {
  size_t index = 0;
  Result<Done> done = session->Edit(
      "Change fill",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectFill*> fill = EntryNamed(p.text("fill"), "fill", &project->fills);
        if (!fill.ok()) return fill.error();
        index = static_cast<size_t>(fill.value() - project->fills.data());
        if (Result<Done> set = SetFields(p, fill.value()); !set.ok()) return set;
        Resolve(session->figure(), &fill.value()->joints);
        if (p.has("name")) {
          fill.value()->name = FreeName(fill.value()->name, project->fills, fill.value());
        }
        return Done();
      },
      p.text("drag"));
  return Measure(session, index, p.has("drag"), std::move(done));
}

Result<Done> RemoveFill(Session* session, const Parameters& p) {
  return session->Edit("Remove fill", [&](Project* project) -> Result<Done> {
    auto& fills = project->fills;
    const Result<ProjectFill*> fill = EntryNamed(p.text("fill"), "fill", &fills);
    if (!fill.ok()) return fill.error();
    if (p.yes("keep")) {
      makers::KeepGeneratedKeys(*fill.value(), session->figure(), project);
    } else {
      makers::RemoveGeneratedKeys(*fill.value(), session->figure(), project);
    }
    fills.erase(fills.begin() + (fill.value() - fills.data()));
    return Done();
  });
}

}  // namespace

std::vector<Operator> FillOperators() {
  return {{"fill.add", "Fill between keys",
           "Fills joints in between their keys, with little effort, by keys of the type generated; "
           "they are made anew when other keys change. Default: the selected joints, else all; "
           "the frames of the selected keys, else of all keys of the joints.",
           FieldsOf<ProjectFill>(), AddFill},
          {"fill.set", "Change fill", "Changes what is given of a fill, and makes its keys anew.",
           Joined({{kFill}, FieldsOf<ProjectFill>(), {kDrag}}), SetFill},
          {"fill.remove",
           "Remove fill",
           "Takes a fill away, and the keys that it wrote.",
           {kFill, {"keep", kYesNo, false, "true: its keys stay, as keys of yours"}},
           RemoveFill}};
}

}  // namespace hazumi::edit
