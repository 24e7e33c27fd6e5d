#include "ui/panels/dope_sheet/bars.h"

#include <algorithm>

namespace hazumi::ui {

namespace {

Error NothingChosen() { return {ErrorCode::kSchema, "", "", "no bar is chosen; click one"}; }

std::optional<BarRef> RegionNamed(const Project& project, const std::string& name) {
  const auto found = std::find_if(project.regions.begin(), project.regions.end(),
                                  [&](const ProjectRegion& region) { return region.name == name; });
  if (found == project.regions.end()) return std::nullopt;
  return BarRef{BarKind::kRegion, static_cast<int>(found - project.regions.begin())};
}

size_t NumOf(const Project& project, BarKind kind) {
  return kind == BarKind::kPlacement ? project.placements.size() : project.holds.size();
}

// Its neighbours give way, so that its index may change. In a drag the operator counts as when that
// began.
Result<Done> EditPlacement(Editor* editor, const BarRef& span, Json change) {
  SheetState& sheet = editor->sheet;
  const std::string drag = change.value("drag", "");
  if (drag.empty() || drag != sheet.span_drag.drag) sheet.span_drag = {drag, span.index, 0};
  change["index"] = sheet.span_drag.index;
  const Project& project = editor->session().project();
  const int first = change.value("first", FramesOf(project, span).first);
  Result<Done> done = editor->Invoke("placement.edit", change);
  sheet.span_drag.revision = editor->session().document().revision();
  if (!done.ok()) return done;
  sheet.span.reset();
  for (size_t i = 0; i < project.placements.size(); ++i) {
    if (project.placements[i].first_frame != first) continue;
    sheet.span = BarRef{BarKind::kPlacement, static_cast<int>(i)};
  }
  return done;
}

std::string TitleOf(const ProjectPlacement& span) {
  const std::string kind = Tr(hazumi::NameOf(span.kind));
  return span.kind == PlacementKind::kPinned ? kind + ": " + span.pin : kind;
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
  if (bar.kind == BarKind::kRegion) return "";
  const ProjectPlacement& span = project.placements[bar.index];
  if (span.kind == PlacementKind::kKeyed) return Tr("The root's keys place the figure.");
  if (span.kind == PlacementKind::kPinned) return Tr("The figure turns about this joint.");
  std::string flies = Tr("The figure flies until it touches something.");
  if (span.landing_pin.empty()) return flies;
  return flies + "\n" + Tr("Pinned after a landing") + ": " + span.landing_pin;
}

std::optional<BarRef> ChosenBar(const Project& project, const SheetState& sheet) {
  if (!sheet.region.empty()) return RegionNamed(project, sheet.region);
  const std::optional<BarRef>& span = sheet.span;
  if (!span || span->index >= static_cast<int>(NumOf(project, span->kind))) return std::nullopt;
  return span;
}

void ChooseBar(Editor* editor, const BarRef& bar) {
  ChooseNoBar(&editor->sheet);
  if (bar.kind == BarKind::kRegion) {
    editor->sheet.region = editor->session().project().regions[bar.index].name;
    editor->side.region = editor->sheet.region;  // the properties show it too
  } else {
    editor->sheet.span = bar;
  }
}

void ChooseNoBar(SheetState* sheet) {
  sheet->region.clear();
  sheet->span.reset();
  sheet->span_drag = {};
}

void RestoreChoice(Editor* editor) {
  const SheetState::SpanDrag& drag = editor->sheet.span_drag;
  const edit::Document& document = editor->session().document();
  if (drag.drag.empty() || document.is_merging() || document.revision() == drag.revision) return;
  ChooseBar(editor, {BarKind::kPlacement, drag.index});
}

Result<Done> EditChosenBar(Editor* editor, Json change) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  if (!bar) return NothingChosen();
  switch (bar->kind) {
    case BarKind::kRegion:
      change["region"] = editor->sheet.region;
      return editor->Invoke("region.set", change);
    case BarKind::kPlacement:
      return EditPlacement(editor, *bar, std::move(change));
    case BarKind::kHold:
      break;
  }
  change["index"] = bar->index;
  return editor->Invoke("hold.set", change);
}

Result<Done> RemoveChosenBar(Editor* editor) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  if (!bar) return NothingChosen();
  const std::string region = editor->sheet.region;
  ChooseNoBar(&editor->sheet);
  switch (bar->kind) {
    case BarKind::kRegion:
      return editor->Invoke("region.remove", {{"region", region}});
    case BarKind::kPlacement:
      return editor->Invoke("placement.remove", {{"index", bar->index}});
    case BarKind::kHold:
      break;
  }
  return editor->Invoke("hold.remove", {{"index", bar->index}});
}

}  // namespace hazumi::ui
