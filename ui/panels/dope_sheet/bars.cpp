#include "ui/panels/dope_sheet/bars.h"

#include <algorithm>

#include "ui/edit/operators/held/holders.h"

namespace hazumi::ui {

namespace {

Error NothingChosen() { return {ErrorCode::kSchema, "", "", "no bar is chosen; click one"}; }

int IndexOfHolder(const Project& project, ItemId id) {
  const auto all = edit::AllHolders(project);
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& holder) {
    return id.is_valid() && holder.second.id == id;
  });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

// In the project's list of its kind; -1 if it is not there.
int IndexOf(const Project& project, const BarId& bar) {
  switch (bar.kind) {
    case BarKind::kRegion:
      return hazumi::IndexOf(bar.id, project.regions);
    case BarKind::kPlacement:
      return hazumi::IndexOf(bar.id, project.placements);
    case BarKind::kHolder:
      return IndexOfHolder(project, bar.id);
    case BarKind::kConstraint:
      return hazumi::IndexOf(bar.id, project.constraints);
    case BarKind::kHold:
      break;
  }
  return hazumi::IndexOf(bar.id, project.holds);
}

// Its neighbours give way, so that its index may change. In a drag the operator counts as when that
// began.
Result<Done> EditPlacement(Editor* editor, const BarId& bar, Json change) {
  const edit::Document& document = editor->session().document();
  const auto* start = document.drag_start(change.value("drag", ""));
  change["index"] = IndexOf(start ? start->project : document.project(), bar);
  return editor->Invoke("placement.edit", change);
}

// Its frames; or else its fields, which for the first holder are the object's own.
Result<Done> EditHolder(Editor* editor, int index, Json change) {
  const Project& project = editor->session().project();
  const auto [object, span] = edit::AllHolders(project)[index];
  change["object"] = project.held_objects[object].name;
  if (change.contains("first")) {
    change["release"] = change["last"];
    change.erase("last");
    change["number"] = span.number;
    return editor->Invoke("held.set_frames", change);
  }
  if (span.number < 0) return editor->Invoke("held.set", change);
  change["number"] = span.number;
  return editor->Invoke("held.set_holder", change);
}

std::string TitleOf(const ProjectPlacement& span) {
  const std::string kind = Tr(hazumi::NameOf(span.kind));
  return span.kind == PlacementKind::kPinned ? kind + ": " + span.pin : kind;
}

std::string NameOfEnd(const ProjectConstraintEnd& end) {
  if (!end.joint.empty()) return end.joint;
  return end.object.empty() ? Tr("the world") : end.object;
}

}  // namespace

ProjectFrames FramesOf(const Project& project, const BarRef& bar) {
  const auto frames = [](const auto& span) {
    return ProjectFrames{span.first_frame, span.last_frame, {}};
  };
  switch (bar.kind) {
    case BarKind::kRegion:
      return frames(project.regions[bar.index]);
    case BarKind::kPlacement:
      return frames(project.placements[bar.index]);
    case BarKind::kHolder: {
      const edit::HolderSpan span = edit::AllHolders(project)[bar.index].second;
      return {span.first, span.last, {}};
    }
    case BarKind::kConstraint:
      return frames(project.constraints[bar.index]);
    case BarKind::kHold:
      break;
  }
  return frames(project.holds[bar.index]);
}

std::string TitleOf(const Project& project, const BarRef& bar) {
  switch (bar.kind) {
    case BarKind::kRegion:
      return project.regions[bar.index].name;
    case BarKind::kPlacement:
      return TitleOf(project.placements[bar.index]);
    case BarKind::kHolder:
      return edit::AllHolders(project)[bar.index].second.joint;
    case BarKind::kConstraint:
      return project.constraints[bar.index].name;
    case BarKind::kHold:
      break;
  }
  return std::string(Tr("held")) + ": " + project.holds[bar.index].joint;
}

std::string DetailsOf(const Project& project, const BarRef& bar) {
  if (bar.kind == BarKind::kHold) {
    return Tr(project.holds[bar.index].orientation
                  ? "Inverse kinematics keeps it in its place and turned as it is."
                  : "Inverse kinematics keeps it in its place.");
  }
  if (bar.kind == BarKind::kHolder) return Tr("This joint holds it; then it flies.");
  if (bar.kind == BarKind::kConstraint) {
    const ProjectConstraint& constraint = project.constraints[bar.index];
    return std::string(Tr(hazumi::NameOf(constraint.kind))) + ": " + NameOfEnd(constraint.a) +
           " - " + NameOfEnd(constraint.b);
  }
  if (bar.kind == BarKind::kRegion) {
    const ProjectRegion& region = project.regions[bar.index];
    if (region.mute) return Tr("Muted: its joints follow their keys.");
    const ProjectContacts& contacts = region.contacts;
    std::string touches;
    if (contacts.scene) touches += Tr("What it moves stays out of the scene's planes and boxes.");
    if (contacts.scene && contacts.self) touches += "\n";
    if (contacts.self) touches += Tr("What it moves stays out of the own body.");
    return touches;
  }
  const ProjectPlacement& span = project.placements[bar.index];
  if (span.kind == PlacementKind::kKeyed) return Tr("The root's keys place the figure.");
  if (span.kind == PlacementKind::kPinned) return Tr("The figure turns about this joint.");
  std::string flies = Tr("The figure flies until it touches something.");
  if (span.landing_pin.empty()) return flies;
  return flies + "\n" + Tr("Pinned after a landing") + ": " + span.landing_pin;
}

std::optional<BarRef> ChosenBar(const Project& project, const SheetState& sheet) {
  if (!sheet.bar) return std::nullopt;
  const int index = IndexOf(project, *sheet.bar);
  return index < 0 ? std::nullopt : std::optional(BarRef{sheet.bar->kind, index});
}

BarId IdOf(const Project& project, const BarRef& bar) {
  switch (bar.kind) {
    case BarKind::kRegion:
      return {bar.kind, project.regions[bar.index].identity.id};
    case BarKind::kPlacement:
      return {bar.kind, project.placements[bar.index].identity.id};
    case BarKind::kHolder:
      return {bar.kind, edit::AllHolders(project)[bar.index].second.id};
    case BarKind::kConstraint:
      return {bar.kind, project.constraints[bar.index].identity.id};
    case BarKind::kHold:
      break;
  }
  return {bar.kind, project.holds[bar.index].identity.id};
}

void ChooseBar(Editor* editor, const BarRef& bar) {
  editor->sheet.bar = IdOf(editor->session().project(), bar);
  if (bar.kind == BarKind::kRegion) editor->side.region = editor->sheet.bar->id;
}

void ChooseNoBar(SheetState* sheet) { sheet->bar.reset(); }

Result<Done> EditChosenBar(Editor* editor, Json change) {
  const Project& project = editor->session().project();
  const std::optional<BarRef> bar = ChosenBar(project, editor->sheet);
  if (!bar) return NothingChosen();
  switch (bar->kind) {
    case BarKind::kRegion:
      change["region"] = project.regions[bar->index].name;
      return editor->Invoke("region.set", change);
    case BarKind::kPlacement:
      return EditPlacement(editor, *editor->sheet.bar, std::move(change));
    case BarKind::kHolder:
      return EditHolder(editor, bar->index, std::move(change));
    case BarKind::kConstraint:
      change["constraint"] = project.constraints[bar->index].name;
      return editor->Invoke("constraint.set", change);
    case BarKind::kHold:
      break;
  }
  change["index"] = bar->index;
  return editor->Invoke("hold.set", change);
}

Result<Done> RemoveChosenBar(Editor* editor) {
  const Project& project = editor->session().project();
  const std::optional<BarRef> bar = ChosenBar(project, editor->sheet);
  if (!bar) return NothingChosen();
  ChooseNoBar(&editor->sheet);
  switch (bar->kind) {
    case BarKind::kRegion:
      return editor->Invoke("region.remove", {{"region", project.regions[bar->index].name}});
    case BarKind::kPlacement:
      return editor->Invoke("placement.remove", {{"index", bar->index}});
    case BarKind::kHolder: {
      const auto& [object, span] = edit::AllHolders(project)[bar->index];
      const std::string& name = project.held_objects[object].name;
      if (span.number < 0) return editor->Invoke("held.set", {{"object", name}, {"joint", ""}});
      return editor->Invoke("held.remove_holder", {{"object", name}, {"number", span.number}});
    }
    case BarKind::kConstraint:
      return editor->Invoke("constraint.remove",
                            {{"constraint", project.constraints[bar->index].name}});
    case BarKind::kHold:
      break;
  }
  return editor->Invoke("hold.remove", {{"index", bar->index}});
}

}  // namespace hazumi::ui
