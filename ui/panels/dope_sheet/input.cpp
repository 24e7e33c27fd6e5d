#include "ui/panels/dope_sheet/input.h"

#include <algorithm>
#include <tuple>

#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/sheet/drag.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/key_tools.h"
#include "ui/panels/viewport/actions.h"

namespace hazumi::ui {

namespace {

// A row's name was clicked: its joints are selected, or its object.
void ClickName(Editor* editor, const SheetRow& row) {
  if (row.object.is_valid()) {
    editor->Do("select.joints", {{"joints", Json::array()}});
    return SelectObject(editor, row.object);
  }
  std::vector<std::string> names;
  for (const JointIndex j : row.hinges) names.push_back(editor->session().figure().joint(j).name);
  if (row.kind == RowKind::kSummary) return;
  if (IsOfRoot(row)) names.push_back(editor->session().figure().root_name());
  const std::set<std::string>& chosen = editor->session().selected_joints();
  const bool are_chosen = std::all_of(names.begin(), names.end(),
                                      [&](const auto& name) { return chosen.contains(name); });
  const ImGuiIO& io = ImGui::GetIO();
  const bool extends = io.KeyShift || io.KeyCtrl;
  const char* mode = !extends ? "replace" : are_chosen ? "remove" : "add";
  editor->Do("select.joints", {{"joints", names}, {"mode", mode}});
}

void ToggleRow(Editor* editor, const std::string& id) {
  std::set<std::string>& open = editor->sheet.open;
  if (!open.erase(id)) open.insert(id);
}

void ClickKey(Editor* editor, const DopeSheetLayout& layout, const RowKey& key, Point mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  ChooseNoBar(&editor->sheet);
  if (io.KeyAlt) {
    editor->Do("keys.select_column",
               {{"frame", key.frame}, {"mode", io.KeyShift ? "add" : "replace"}});
    return;
  }
  const KeyList keys = KeysOf(layout, key, editor->session().project());
  if (io.KeyShift) return SelectKeys(editor, keys, "toggle");
  MoveKeysOptions options;
  options.by_button = true;
  if (key.is_selected) {
    options.click = keys;
  } else {
    SelectKeys(editor, keys, "replace");
  }
  editor->Take(MakeMoveKeys(editor, mouse, options));
}

// Opens the menu of a bar on the row where it was clicked.
void OpenBar(Editor* editor, const DopeSheetLayout& layout, const RowBar& bar) {
  ChooseBar(editor, bar.ref);
  editor->sheet.popup = SheetPopup::kBar;
  editor->sheet.bar_row = layout.rows[bar.row].id;
}

void ClickBar(Editor* editor, const DopeSheetLayout& layout, const RowBar& bar, SheetPart part,
              Point mouse) {
  ChooseBar(editor, bar.ref);
  if (!editor->session().selected_keys().empty()) SelectKeys(editor, {}, "replace");
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    OpenBar(editor, layout, bar);
  } else if (!ImGui::GetIO().KeyShift) {
    editor->Take(part == SheetPart::kBarStrength ? MakeDragStrength(editor, mouse, bar)
                                                 : MakeDragBar(editor, mouse, part));
  } else {
    editor->Take(MakeBoxSelect(editor, mouse, true));
  }
}

void Click(Editor* editor, const DopeSheetLayout& layout, const SheetHit& hit, Point mouse) {
  switch (hit.part) {
    case SheetPart::kCorner:
      editor->Do("sheet.only_selected");
      return;
    case SheetPart::kArrow:
      return ToggleRow(editor, layout.rows[hit.row].id);
    case SheetPart::kName:
      if (ImGui::IsMouseDoubleClicked(0)) ToggleRow(editor, layout.rows[hit.row].id);
      return ClickName(editor, layout.rows[hit.row]);
    case SheetPart::kKey:
      return ClickKey(editor, layout, layout.keys[hit.index], mouse);
    case SheetPart::kBar:
    case SheetPart::kBarStart:
    case SheetPart::kBarEnd:
    case SheetPart::kBarStrength:
      return ClickBar(editor, layout, layout.bars[hit.index], hit.part, mouse);
    case SheetPart::kTrack:
    case SheetPart::kNothing:
      ChooseNoBar(&editor->sheet);
      if (layout.frame.tracks.Contains(mouse)) editor->Take(MakeBoxSelect(editor, mouse, true));
      return;
    case SheetPart::kRuler:
    case SheetPart::kMarker:
      ClickRuler(editor, layout.frame, mouse);
      return;
  }
}

bool IsEnd(SheetPart part) { return part == SheetPart::kBarStart || part == SheetPart::kBarEnd; }
bool IsOfBar(SheetPart part) {
  return part == SheetPart::kBar || part == SheetPart::kBarStrength || IsEnd(part);
}

// The right button opens what can be done with what is under it.
void RightClick(Editor* editor, const DopeSheetLayout& layout, const SheetHit& hit) {
  if (IsOfBar(hit.part)) {
    return OpenBar(editor, layout, layout.bars[hit.index]);
  }
  if (hit.part == SheetPart::kKey && !layout.keys[hit.index].is_selected) {
    SelectKeys(editor, KeysOf(layout, layout.keys[hit.index], editor->session().project()),
               "replace");
  }
  RightClickSheet(editor, layout.frame, FromIm(ImGui::GetIO().MousePos));
}

void ExplainStrength(const RowBar& bar) {
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  const std::optional<double>& strength = bar.muscle.strength;
  Tooltip(std::string(Tr("Strength")) + ": " + (strength ? PercentText(*strength) : Tr("No limit")),
          Tr("Drag it up or down: how strong the spring is"));
}

void ExplainBar(const Project& project, const RowBar& of) {
  const BarRef& bar = of.ref;
  const ProjectFrames frames = FramesOf(project, bar);
  std::string text =
      TitleOf(project, bar) + "   " + Tr("frames") + " " + SpanText(frames.first, frames.last);
  const std::string details = DetailsOf(project, bar);
  if (!details.empty()) text += "\n" + details;
  const bool is_region = bar.kind == BarKind::kRegion;
  if (is_region && of.num_held > 0 && !project.regions[bar.index].mute) {
    text += "\n" + std::string(Tr("Muscle")) + ": " + TextOf(of.muscle);
  }
  Tooltip(text, Tr(is_region ? "Drag it or its ends; double click for friction and more"
                             : "Drag it or its ends; double click to change it, X deletes it"));
}

void ShowWhatIsUnder(Editor* editor, const DopeSheetLayout& layout, const SheetHit& hit) {
  if (IsEnd(hit.part)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (hit.part == SheetPart::kCorner) Tooltip(Tr("Shows the rows of the selected joints alone"));
  if (hit.part == SheetPart::kBarStrength) return ExplainStrength(layout.bars[hit.index]);
  if (hit.part != SheetPart::kBar) return;
  ExplainBar(editor->session().project(), layout.bars[hit.index]);
}

void ScrollRows(SheetState* sheet, const DopeSheetLayout& layout) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.KeyCtrl) sheet->scroll_px -= 40.0 * layout.frame.scale * io.MouseWheel;
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f) && !io.KeyCtrl) {
    sheet->scroll_px -= io.MouseDelta.y;
  }
  const double most = std::max(0.0f, layout.content_height - layout.frame.tracks.h);
  sheet->scroll_px = std::clamp(sheet->scroll_px, 0.0, most);
}

}  // namespace

bool TakeDopeSheetInput(Editor* editor, const DopeSheetLayout& layout) {
  const SheetState& sheet = editor->sheet;
  const auto view = [&] { return std::tuple(sheet.first, sheet.last, sheet.scroll_px); };
  const auto view_before = view();
  const bool is_hovered = ImGui::IsItemHovered();
  if (is_hovered || ImGui::IsItemActive()) {
    NavigateTime(editor, layout.frame);
    ScrollRows(&editor->sheet, layout);
  }
  const bool has_moved = view() != view_before;
  if (!is_hovered || editor->has_tool() || sheet.is_quiet) return has_moved;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const SheetHit hit = HitDopeSheet(layout, editor->session(), mouse);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    Click(editor, layout, hit, mouse);
    return true;
  }
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    RightClick(editor, layout, hit);
    return true;
  }
  ShowWhatIsUnder(editor, layout, hit);
  return has_moved;
}

}  // namespace hazumi::ui
