#include "ui/panels/dope_sheet/span_actions.h"

#include <algorithm>
#include <cmath>

#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::ui::span {

namespace {

int FrameNow(const Editor& editor) {
  return static_cast<int>(std::lround(editor.session().frame()));
}

// The selected joint.
Result<std::string> JointOf(const Editor& editor, const char* missing) {
  const edit::Session& session = editor.session();
  const auto active = ActiveJoint(session.figure(), session.selected_joints(), editor.side.active);
  if (!active) return Error{ErrorCode::kSchema, "", "", Tr(missing)};
  return session.figure().group(*active).name;
}

// `last`, or where a later entry begins of which `is_in_way`.
template <typename T, typename Test>
int Until(const std::vector<T>& spans, int now, int last, Test is_in_way) {
  for (const T& span : spans) {
    if (span.first_frame > now && is_in_way(span)) last = std::min(last, span.first_frame);
  }
  return last;
}

Result<Done> Place(Editor* editor, const char* kind, const std::string& pin) {
  const Project& project = editor->session().project();
  const int now = FrameNow(*editor);
  const int last = Until(project.placements, now, project.frames.last,
                         [](const ProjectPlacement&) { return true; });
  Json span = {{"kind", kind}, {"first", now}, {"last", last}};
  if (!pin.empty()) span["pin"] = pin;
  Result<Done> done = editor->Invoke("placement.set", span);
  for (size_t i = 0; done.ok() && i < project.placements.size(); ++i) {
    if (project.placements[i].first_frame != now) continue;
    ChooseBar(editor, {BarKind::kPlacement, static_cast<int>(i)});
  }
  return done;
}

// Nothing that places the figure by the joint itself, nor gravity, can go with a hold of it.
int HoldUntil(const Project& project, const std::string& joint, int now) {
  const int last = Until(project.holds, now, project.frames.last,
                         [&](const ProjectHold& hold) { return hold.joint == joint; });
  return Until(project.placements, now, last, [&](const ProjectPlacement& span) {
    return span.kind == PlacementKind::kGravity || span.pin == joint;
  });
}

// A limb of six hinges or more, such as a leg, can keep the foot turned as it is, too.
Result<Done> HoldFromNow(Editor* editor, GroupIndex joint, const std::string& drag) {
  const Figure& figure = editor->session().figure();
  const std::string& name = figure.group(joint).name;
  int num_hinges = 0;
  for (const GroupIndex g : ChainOf(joint, std::nullopt, figure)) {
    num_hinges += figure.group(g).size;
  }
  const int now = FrameNow(*editor);
  return editor->Invoke("hold.add", {{"joint", name},
                                     {"orientation", num_hinges >= edit::kFullyMovable},
                                     {"first", now},
                                     {"last", HoldUntil(editor->session().project(), name, now)},
                                     {"drag", drag}});
}

}  // namespace

Result<Done> Pin(Editor* editor, const Parameters&) {
  const Result<std::string> joint = JointOf(*editor, "Select the joint that is to be pinned.");
  return joint.ok() ? Place(editor, "pinned", joint.value()) : joint.error();
}

Result<Done> Gravity(Editor* editor, const Parameters&) { return Place(editor, "gravity", ""); }

Result<Done> Hold(Editor* editor, const Parameters&) {
  const std::vector<GroupIndex> joints = SelectedJoints(editor->session());
  if (joints.empty()) {
    return Error{ErrorCode::kSchema, "", "", Tr("Select the joint that is to be held.")};
  }
  const std::string drag = "span.hold " + std::to_string(++editor->viewport.drags);
  editor->Do("edit.end_drag");
  for (const GroupIndex joint : joints) {
    Result<Done> done = HoldFromNow(editor, joint, drag);
    if (done.ok()) continue;
    editor->Do("edit.cancel_drag");
    return done;
  }
  editor->Do("edit.end_drag");
  const size_t num_holds = editor->session().project().holds.size();
  ChooseBar(editor, {BarKind::kHold, static_cast<int>(num_holds) - 1});
  return Done();
}

}  // namespace hazumi::ui::span
