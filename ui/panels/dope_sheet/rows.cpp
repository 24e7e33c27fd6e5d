// Which rows the dope sheet has.

#include <algorithm>
#include <cctype>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/outliner/limbs.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

class RowList {
 public:
  RowList(const edit::Session& session, const SheetState& state)
      : session_(session), figure_(session.figure()), state_(state) {}

  std::vector<SheetRow> Collect() {
    AddSummary();
    AddPlacement();
    for (const ProjectHeldObject& object : session_.project().held_objects) AddObject(object);
    AddRoot();
    for (const Limb& limb : LimbsOf(figure_)) AddLimb(limb);
    return std::move(rows_);
  }

 private:
  void AddSummary() {
    SheetRow row{RowKind::kSummary, "summary", Tr("Summary")};
    row.curves = CurveNames(session_.project());
    std::erase_if(row.curves, [&](const std::string& name) { return !IsShown(name); });
    rows_.push_back(std::move(row));
  }

  void AddPlacement() {
    AddOfRoot({RowKind::kPlacement, "placement", Tr("Placement")}, 0, kRootAngleZ);
  }

  // Adds the orientation of the root. Regions move it like a limb.
  void AddRoot() {
    if (!IsShown(kRootCurveNames[kRootAngleZ])) return;
    SheetRow row{RowKind::kRoot, "root", Tr("Root")};
    if (const std::string name = NameOfRoot(figure_); !name.empty()) row.refs = {name};
    AddOfRoot(std::move(row), kRootAngleZ, kNumRootCurves);
  }

  // Adds a row with the curves of the root from `first` to before `end`.
  void AddOfRoot(SheetRow row, int first, int end) {
    row.has_parts = true;
    row.is_open = state_.open.contains(row.id);
    row.curves.assign(kRootCurveNames + first, kRootCurveNames + end);
    const bool is_open = row.is_open;
    const std::vector<std::string> curves = row.curves;
    rows_.push_back(std::move(row));
    for (const std::string& name : curves) {
      if (is_open)
        rows_.push_back({RowKind::kCurve, name, name.substr(5), 1, false, false, {name}});
    }
  }

  void AddObject(const ProjectHeldObject& object) {
    if (state_.only_selected) return;
    SheetRow row{RowKind::kObject, "held " + object.name, object.name};
    row.object = object.identity.id;
    for (int axis = 0; axis < 3; ++axis) row.curves.push_back(NameOfCurve(object, axis));
    rows_.push_back(std::move(row));
  }

  bool IsShown(const std::string& curve) const {
    const std::string& owner = RootCurveNamed(curve) ? figure_.root_name() : curve;
    return !state_.only_selected || session_.selected_joints().contains(owner);
  }

  // Takes the hinges of a joint that are shown.
  void AddHinges(GroupIndex joint, SheetRow* row) const {
    for (const JointIndex j : HingesOf(figure_, joint)) {
      if (!IsShown(figure_.joint(j).name)) continue;
      row->hinges.push_back(j);
      row->curves.push_back(figure_.joint(j).name);
    }
  }

  void AddLimb(const Limb& limb) {
    const std::string& first = figure_.group(limb.joints.front()).name;
    SheetRow row{RowKind::kLimb, "limb " + first, Tr(limb.name.c_str())};
    for (const GroupIndex joint : limb.joints) AddHinges(joint, &row);
    if (row.hinges.empty()) return;
    row.has_parts = true;
    row.is_open = state_.open.contains(row.id);
    for (const GroupIndex joint : limb.joints) {
      if (!limb.is_end) row.refs.push_back(figure_.group(joint).name);
    }
    if (limb.is_end) row.refs = {first + "+"};
    const bool is_open = row.is_open;
    rows_.push_back(std::move(row));
    for (const GroupIndex joint : limb.joints) {
      if (is_open) AddJoint(joint);
    }
  }

  void AddJoint(GroupIndex joint) {
    const std::string& name = figure_.group(joint).name;
    SheetRow row{RowKind::kJoint, "joint " + name, name, 1};
    AddHinges(joint, &row);
    if (row.hinges.empty()) return;
    row.refs = {name};
    row.has_parts = figure_.group(joint).size > 1;
    row.is_open = row.has_parts && state_.open.contains(row.id);
    const std::vector<JointIndex> hinges = row.is_open ? row.hinges : std::vector<JointIndex>();
    rows_.push_back(std::move(row));
    for (const JointIndex j : hinges) {
      const std::string& hinge = figure_.joint(j).name;
      const bool is_longer = hinge.starts_with(name + "_");
      rows_.push_back({RowKind::kCurve,
                       hinge,
                       is_longer ? hinge.substr(name.size() + 1) : hinge,
                       2,
                       false,
                       false,
                       {hinge},
                       {j},
                       {hinge}});
    }
  }

  const edit::Session& session_;
  const Figure& figure_;
  const SheetState& state_;
  std::vector<SheetRow> rows_;
};

// "arms" for both of them, "right arm" for one, "region" for anything else.
std::string NameOfRegion(const std::vector<const SheetRow*>& rows) {
  const auto are = [&](const std::string& a, const std::string& b) {
    return rows.size() == 2 && ((rows[0]->name == a && rows[1]->name == b) ||
                                (rows[0]->name == b && rows[1]->name == a));
  };
  if (are(Tr("Right arm"), Tr("Left arm"))) return "arms";
  if (are(Tr("Right leg"), Tr("Left leg"))) return "legs";
  if (rows.size() != 1) return "region";
  std::string name = rows[0]->name;
  const bool is_ascii = static_cast<unsigned char>(name[0]) < 0x80;
  if (is_ascii) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

bool IsOfRoot(const SheetRow& row) {
  const bool is_other = row.kind == RowKind::kSummary || row.kind == RowKind::kObject;
  return !is_other && row.hinges.empty();
}

std::vector<SheetRow> SheetRows(const edit::Session& session, const SheetState& state) {
  return RowList(session, state).Collect();
}

RegionOnRows RegionOn(const DopeSheetLayout& layout, int first_row, int last_row) {
  std::vector<const SheetRow*> rows;
  RegionOnRows region;
  for (int i = std::min(first_row, last_row); i <= std::max(first_row, last_row); ++i) {
    const SheetRow& row = layout.rows[i];
    // What a row holds its parts need not say again.
    const bool is_said = std::any_of(rows.begin(), rows.end(), [&](const SheetRow* above) {
      return !row.hinges.empty() && std::includes(above->hinges.begin(), above->hinges.end(),
                                                  row.hinges.begin(), row.hinges.end());
    });
    if (row.refs.empty() || is_said) continue;
    rows.push_back(&row);
    region.joints.insert(region.joints.end(), row.refs.begin(), row.refs.end());
  }
  if (!rows.empty()) region.name = NameOfRegion(rows);
  return region;
}

RegionOnRows WithRootOfWhole(RegionOnRows region, const Figure& figure) {
  std::vector<JointRef> refs;
  for (const std::string& name : region.joints) refs.push_back({name, false, {}});
  const std::vector<bool> moved = JointsOf(refs, figure);
  const std::string root = NameOfRoot(figure);
  const bool is_whole = std::find(moved.begin(), moved.end(), false) == moved.end();
  if (!is_whole || refs.empty() || root.empty()) return region;
  if (!NameRoot(refs, figure)) region.joints.insert(region.joints.begin(), root);
  region.name = "body";
  return region;
}

}  // namespace hazumi::ui
