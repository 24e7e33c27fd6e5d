#include "ui/panels/sheet/actions.h"

#include <algorithm>

#include "ui/edit/operators/edits.h"
#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/graph/layout.h"
#include "ui/panels/sheet/drag.h"
#include "ui/panels/sheet/key_tools.h"
#include "ui/panels/sheet/popups.h"

namespace hazumi::ui::sheet {

namespace {

Error NoKeys() { return {ErrorCode::kSchema, "", "", "no key is selected; click one"}; }

Result<Done> TakeMove(Editor* editor, bool duplicates) {
  if (editor->session().selected_keys().empty()) return NoKeys();
  MoveKeysOptions options;
  options.duplicates = duplicates;
  if (editor->sheet.kind == SheetKind::kGraph) options.value_per_px = ValuePerPx(editor);
  editor->Take(MakeMoveKeys(editor, editor->mouse, options));
  return Done();
}

void Show(Editor* editor, double first, double last) {
  const TimeAxis axis = Showing(SheetAxis(*editor), first, last);
  editor->sheet.first = axis.first;
  editor->sheet.last = axis.last;
}

}  // namespace

Result<Done> MoveKeys(Editor* editor, const Parameters&) { return TakeMove(editor, false); }
Result<Done> DuplicateKeys(Editor* editor, const Parameters&) { return TakeMove(editor, true); }

Result<Done> ScaleKeys(Editor* editor, const Parameters&) {
  if (editor->session().selected_keys().empty()) return NoKeys();
  editor->Take(MakeScaleKeys(editor, editor->mouse));
  return Done();
}

Result<Done> BoxSelect(Editor* editor, const Parameters&) {
  editor->Take(MakeBoxSelect(editor, editor->mouse, false));
  return Done();
}

Result<Done> SelectAll(Editor* editor, const Parameters&) {
  std::vector<std::string> curves;
  if (editor->sheet.kind == SheetKind::kGraph) {
    curves = ShownCurves(editor->session(), editor->sheet);
  } else {
    for (const SheetRow& row : SheetRows(editor->session(), editor->sheet)) {
      const bool is_part = row.depth > 0 || row.kind == RowKind::kSummary;
      if (!is_part) curves.insert(curves.end(), row.curves.begin(), row.curves.end());
    }
  }
  std::erase_if(curves, [&](const std::string& name) {
    return !FindCurve(name, editor->session().project());
  });
  return editor->session().Run("keys.select_all", {{"curves", curves}});
}

Result<Done> Delete(Editor* editor, const Parameters&) {
  if (!editor->session().selected_keys().empty()) return editor->session().Run("keys.delete");
  if (!ChosenBar(editor->session().project(), editor->sheet)) return NoKeys();
  return RemoveChosenBar(editor);
}

Result<Done> Mute(Editor* editor, const Parameters&) {
  const Project& project = editor->session().project();
  const std::optional<BarRef> bar = ChosenBar(project, editor->sheet);
  if (!bar || bar->kind != BarKind::kRegion) {
    return Error{ErrorCode::kSchema, "", "", Tr("Click the bar of a region first.")};
  }
  const ProjectRegion& region = project.regions[bar->index];
  return editor->Invoke("region.set", {{"region", region.name}, {"mute", !region.mute}});
}

Result<Done> MarkRegion(Editor* editor, const Parameters&) {
  editor->sheet.kind = SheetKind::kDopeSheet;
  editor->Take(MakePaintRegion(editor, editor->mouse));
  return Done();
}

Result<Done> Rename(Editor* editor, const Parameters&) {
  const Project& project = editor->session().project();
  const auto marker =
      std::find_if(project.markers.begin(), project.markers.end(),
                   [&](const ProjectMarker& m) { return m.frame == editor->session().frame(); });
  if (marker != project.markers.end()) {
    OpenMarker(editor, static_cast<int>(marker - project.markers.begin()));
    return Done();
  }
  const std::optional<BarRef> bar = ChosenBar(project, editor->sheet);
  if (!bar || bar->kind != BarKind::kRegion) {
    return Error{ErrorCode::kSchema, "", "",
                 Tr("There is no marker on this frame; go to one, or click the bar of a region.")};
  }
  editor->sheet.popup = SheetPopup::kBar;
  return Done();
}

Result<Done> PreviewRange(Editor* editor, const Parameters&) {
  editor->Take(MakePreviewRange(editor, editor->mouse));
  return Done();
}

Result<Done> Open(Editor* editor, const Parameters& p) {
  if (editor->session().selected_keys().empty()) return NoKeys();
  const std::string popup = p.text("popup");
  const std::pair<const char*, SheetPopup> popups[] = {
      {"interpolation", SheetPopup::kInterpolation},
      {"handles", SheetPopup::kHandles},
      {"key_type", SheetPopup::kKeyType}};
  for (const auto& [name, value] : popups) {
    if (popup != name) continue;
    editor->sheet.popup = value;
    return Done();
  }
  return Error{ErrorCode::kSchema, "", "popup",
               "\"" + popup + "\" is none of interpolation, handles, key_type"};
}

Result<Done> OnlySelected(Editor* editor, const Parameters&) {
  editor->sheet.only_selected = !editor->sheet.only_selected;
  return Done();
}

Result<Done> FrameAll(Editor* editor, const Parameters&) {
  const ProjectFrames& all = editor->session().project().frames;
  Show(editor, all.first, all.last);
  editor->sheet.fits_values = true;
  return Done();
}

Result<Done> FrameSelected(Editor* editor, const Parameters&) {
  const KeySelection& keys = editor->session().selected_keys();
  if (keys.empty()) return NoKeys();
  double first = *keys.begin()->second.begin(), last = first;
  for (const auto& [curve, frames] : keys) {
    first = std::min(first, *frames.begin());
    last = std::max(last, *frames.rbegin());
  }
  Show(editor, first, last);
  FrameValues(editor, keys);
  return Done();
}

}  // namespace hazumi::ui::sheet
