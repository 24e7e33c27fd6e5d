#include "ui/panels/outliner/input.h"

#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/actions.h"

namespace hazumi::ui {

namespace {

// Joints know when they are opened, all others when they are closed.
void Toggle(const OutlinerRow& row, SideState* side) {
  std::set<std::string>& names = row.kind == OutlinerRowKind::kJoint ? side->opened : side->closed;
  if (names.erase(row.name) == 0) names.insert(row.name);
}

// The joint that a hinge belongs to.
std::string JointOf(const OutlinerRow& row, const Figure& figure) {
  const std::optional<JointIndex> hinge = figure.FindJoint(row.name);
  if (row.kind != OutlinerRowKind::kHinge || !hinge) return row.name;
  return figure.group(figure.joint(*hinge).group).name;
}

void SelectJoints(Editor* editor, const std::vector<OutlinerRow>& rows, size_t row,
                  ClickMode click) {
  const edit::Session& session = editor->session();
  SideState& side = editor->side;
  const JointClick joints =
      ClickOn(rows, row, side.anchor, click, session.selected_joints(), session.figure());
  if (!editor->Do("select.joints", {{"joints", joints.names}, {"mode", joints.mode}})) return;
  side.active = JointOf(rows[row], session.figure());
  const bool shows_joints = side.section == Section::kPose || side.section == Section::kRegion;
  if (!shows_joints) side.section = Section::kPose;
}

// Hides or locks what is not, and the other way round.
void Switch(Editor* editor, const char* id, const OutlinerRow& row,
            const std::set<std::string>& now) {
  const bool is_on = ShareOf(row, now, editor->session().figure()) == Share::kAll;
  editor->Do(id, {{"joints", {row.name}}, {"on", !is_on}});
}

// An item that is not an object is shown by its bar, and among the scene's properties.
void ChooseItem(Editor* editor, const OutlinerRow& row) {
  editor->Do("select.joints", {{"joints", Json::array()}});
  const bool is_object = row.thing == Thing::kObject || row.thing == Thing::kHeldObject;
  SelectObject(editor, is_object ? row.item : ItemId());
  const Project& project = editor->session().project();
  if (const auto bar = FindBar(project, {row.thing, row.item})) ChooseBar(editor, *bar);
}

}  // namespace

void ClickOutliner(Editor* editor, const std::vector<OutlinerRow>& rows, const OutlinerHit& hit,
                   ClickMode click) {
  const OutlinerRow& row = rows[hit.row];
  SideState& side = editor->side;
  if (hit.part == OutlinerPart::kDisclosure || row.kind == OutlinerRowKind::kHeading) {
    return Toggle(row, &side);
  }
  const edit::Session& session = editor->session();
  if (hit.part == OutlinerPart::kEye) {
    return Switch(editor, "joint.hide", row, session.hidden_joints());
  }
  if (hit.part == OutlinerPart::kLock) {
    return Switch(editor, "joint.lock", row, session.locked_joints());
  }
  if (IsSelectable(row)) {
    SelectJoints(editor, rows, hit.row, click);
  } else {
    side.active = row.name;
    side.section = Section::kScene;
    if (row.kind == OutlinerRowKind::kItem) ChooseItem(editor, row);
  }
  if (click != ClickMode::kExtend) side.anchor = row.name;
}

}  // namespace hazumi::ui
