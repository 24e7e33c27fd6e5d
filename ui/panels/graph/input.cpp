#include "ui/panels/graph/input.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/sheet/drag.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/key_tools.h"

namespace hazumi::ui {

namespace {

void ClickKey(Editor* editor, const GraphLayout& layout, const GraphKey& key, Point mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyAlt) {
    editor->Do("keys.select_column",
               {{"frame", key.frame}, {"mode", io.KeyShift ? "add" : "replace"}});
    return;
  }
  const KeyList one = {{layout.curves[key.curve].name}, {key.frame}};
  if (io.KeyShift) return SelectKeys(editor, one, "toggle");
  MoveKeysOptions options;
  options.by_button = true;
  if (key.is_selected) {
    options.click = one;
  } else {
    SelectKeys(editor, one, "replace");
  }
  options.value_per_px = (layout.values.high - layout.values.low) / layout.frame.tracks.h /
                         layout.curves[key.curve].stretch;
  editor->Take(MakeMoveKeys(editor, mouse, options));
}

void Click(Editor* editor, const GraphLayout& layout, const GraphHit& hit, Point mouse) {
  switch (hit.part) {
    case GraphPart::kCorner:
      editor->Do("sheet.normalize");
      return;
    case GraphPart::kName: {
      std::set<std::string>& hidden = editor->sheet.hidden;
      const std::string& name = layout.curves[hit.index].name;
      if (!hidden.erase(name)) hidden.insert(name);
      return;
    }
    case GraphPart::kKey:
      return ClickKey(editor, layout, layout.keys[hit.index], mouse);
    case GraphPart::kHandle: {
      const GraphKey& key = layout.keys[hit.index];
      return editor->Take(
          MakeDragHandle(editor, mouse, key, hit.side, layout.curves[key.curve].name));
    }
    case GraphPart::kTorqueToggle:
      editor->Do("sheet.torque");
      return;
    case GraphPart::kTrack:
      return editor->Take(MakeBoxSelect(editor, mouse, true));
    case GraphPart::kRuler:
      ClickRuler(editor, layout.frame, mouse);
      return;
    case GraphPart::kTorque:
    case GraphPart::kNothing:
      return;
  }
}

// The wheel zooms values about the mouse, the middle button moves them.
void NavigateValues(SheetState* sheet, const GraphLayout& layout) {
  const ImGuiIO& io = ImGui::GetIO();
  ValueRange& values = sheet->values;
  if (io.MouseWheel != 0.0f && !io.KeyCtrl) {
    const double about = layout.ShownAt(io.MousePos.y), factor = std::pow(1.15, -io.MouseWheel);
    constexpr double kLeast = 1e-4, kMost = 1e7;
    const double size = std::clamp((values.high - values.low) * factor, kLeast, kMost);
    const double part = (about - values.low) / (values.high - values.low);
    values.low = about - part * size;
    values.high = values.low + size;
    sheet->fits_values = false;
  }
  if (!ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f) || io.MouseDelta.y == 0.0f) return;
  const double by = io.MouseDelta.y * (values.high - values.low) / layout.frame.tracks.h;
  if (io.KeyCtrl) return;
  values.low += by;
  values.high += by;
  sheet->fits_values = false;
}

void Explain(const Editor& editor, const GraphLayout& layout, const GraphHit& hit, Point mouse) {
  if (hit.part == GraphPart::kCorner) Tooltip(Tr("Draws each curve as high as the graph"));
  if (hit.part == GraphPart::kName) {
    Tooltip(layout.curves[hit.index].name, Tr("Click: show or hide"));
  }
  if (hit.part == GraphPart::kTorqueToggle) Tooltip(HelpOf("sheet.torque"));
  if (hit.part == GraphPart::kTorque) {
    const std::string text = TorqueTextAt(editor.effort, layout, mouse);
    if (!text.empty()) Tooltip(text);
  }
  if (hit.part != GraphPart::kKey) return;
  const GraphKey& key = layout.keys[hit.index];
  Tooltip(layout.curves[key.curve].name + "   " + Tr("frame") + " " + FormatShort(key.frame) +
          "   " + FormatShort(key.value));
}

}  // namespace

void TakeGraphInput(Editor* editor, const GraphLayout& layout) {
  const bool is_hovered = ImGui::IsItemHovered();
  if (is_hovered || ImGui::IsItemActive()) {
    NavigateTime(editor, layout.frame);
    NavigateValues(&editor->sheet, layout);
  }
  if (!is_hovered || editor->has_tool() || editor->sheet.is_quiet) return;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const GraphHit hit = HitGraph(layout, mouse);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    Click(editor, layout, hit, mouse);
  } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    RightClickSheet(editor, layout.frame, mouse);
  } else {
    Explain(*editor, layout, hit, mouse);
  }
}

}  // namespace hazumi::ui
