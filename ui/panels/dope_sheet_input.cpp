#include "ui/panels/dope_sheet_input.h"

#include <algorithm>

#include "ui/panels/key_tools.h"
#include "ui/panels/region_tools.h"
#include "ui/panels/sheet_drawing.h"

namespace hazumi::ui {

namespace {

// A row's name was clicked: its joints are selected.
void ClickName(Editor* editor, const SheetRow& row) {
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
  editor->sheet.region.clear();
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

void ClickBar(Editor* editor, const RowBar& bar, SheetPart part, Point mouse) {
  if (!bar.is_region) return editor->Take(MakeBoxSelect(editor, mouse, true));
  editor->sheet.region = editor->session().project().regions[bar.index].name;
  if (!editor->session().selected_keys().empty()) SelectKeys(editor, {}, "replace");
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    editor->sheet.popup = SheetPopup::kRegion;
  } else if (!ImGui::GetIO().KeyShift) {
    editor->Take(MakeDragRegion(editor, mouse, editor->sheet.region, part));
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
      return ClickBar(editor, layout.bars[hit.index], hit.part, mouse);
    case SheetPart::kTrack:
    case SheetPart::kNothing:
      editor->sheet.region.clear();
      if (layout.frame.tracks.Contains(mouse)) editor->Take(MakeBoxSelect(editor, mouse, true));
      return;
    case SheetPart::kRuler:
    case SheetPart::kMarker:
      ClickRuler(editor, layout.frame, mouse);
      return;
  }
}

// The right button opens what can be done with what is under it.
void RightClick(Editor* editor, const DopeSheetLayout& layout, const SheetHit& hit) {
  const bool is_bar = hit.part == SheetPart::kBar || hit.part == SheetPart::kBarStart ||
                      hit.part == SheetPart::kBarEnd;
  if (is_bar && layout.bars[hit.index].is_region) {
    editor->sheet.region = editor->session().project().regions[layout.bars[hit.index].index].name;
    editor->sheet.popup = SheetPopup::kRegion;
  } else if (hit.part == SheetPart::kKey ||
             layout.frame.tracks.Contains(FromIm(ImGui::GetIO().MousePos))) {
    if (hit.part == SheetPart::kKey && !layout.keys[hit.index].is_selected) {
      SelectKeys(editor, KeysOf(layout, layout.keys[hit.index], editor->session().project()),
                 "replace");
    }
    editor->sheet.popup = SheetPopup::kKeys;
  }
}

void ShowWhatIsUnder(Editor* editor, const DopeSheetLayout& layout, const SheetHit& hit) {
  if (hit.part == SheetPart::kBarStart || hit.part == SheetPart::kBarEnd) {
    if (layout.bars[hit.index].is_region) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (hit.part == SheetPart::kCorner) Tooltip(Tr("Shows the rows of the selected joints alone"));
  if (hit.part != SheetPart::kBar || !layout.bars[hit.index].is_region) return;
  const ProjectRegion& region = editor->session().project().regions[layout.bars[hit.index].index];
  Tooltip(region.name + "   " + Tr("frames") + " " + std::to_string(region.first_frame) + " - " +
              std::to_string(region.last_frame),
          Tr("Drag it or its ends; double click for friction and more"));
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

void TakeDopeSheetInput(Editor* editor, const DopeSheetLayout& layout) {
  const bool is_hovered = ImGui::IsItemHovered();
  if (is_hovered || ImGui::IsItemActive()) {
    NavigateTime(editor, layout.frame);
    ScrollRows(&editor->sheet, layout);
  }
  if (!is_hovered || editor->has_tool()) return;
  if (editor->sheet.quiet_frame == ImGui::GetFrameCount()) return;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const SheetHit hit = HitDopeSheet(layout, editor->session(), mouse);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    Click(editor, layout, hit, mouse);
  } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    RightClick(editor, layout, hit);
  } else {
    ShowWhatIsUnder(editor, layout, hit);
  }
}

}  // namespace hazumi::ui
