#include "ui/panels/span_actions.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/properties_layout.h"
#include "ui/panels/sheet_bars.h"

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
  const Result<Done> done = editor->Invoke("placement.set", span);
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

}  // namespace

Result<Done> Pin(Editor* editor, const Parameters&) {
  const Result<std::string> joint = JointOf(*editor, "Select the joint that is to be pinned.");
  return joint.ok() ? Place(editor, "pinned", joint.value()) : joint.error();
}

Result<Done> Gravity(Editor* editor, const Parameters&) { return Place(editor, "gravity", ""); }

Result<Done> Hold(Editor* editor, const Parameters&) {
  const Result<std::string> joint = JointOf(*editor, "Select the joint that is to be held.");
  if (!joint.ok()) return joint.error();
  const Project& project = editor->session().project();
  const int now = FrameNow(*editor), last = HoldUntil(project, joint.value(), now);
  const Result<Done> done =
      editor->Invoke("hold.add", {{"joint", joint.value()}, {"first", now}, {"last", last}});
  if (!done.ok()) return done;
  ChooseBar(editor, {BarKind::kHold, static_cast<int>(project.holds.size()) - 1});
  return done;
}

}  // namespace hazumi::ui::span
