#include "ui/panels/commands/actions.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/popups.h"

namespace hazumi::ui {

void OpenMarker(Editor* editor, int marker) {
  editor->sheet.marker = editor->session().project().markers[marker].identity.id;
  editor->sheet.popup = SheetPopup::kMarker;
}

void DrawMarkerItems(Editor* editor) {
  const std::vector<ProjectMarker>& markers = editor->session().project().markers;
  const int index = IndexOf(editor->sheet.marker, markers);
  if (index < 0) return ImGui::CloseCurrentPopup();
  ImGui::TextDisabled("%s %d", Tr("Marker on frame"), markers[index].frame);
  ImGui::Separator();
  ImGui::SetNextItemWidth(12.0f * ImGui::GetFontSize());
  if (const auto name = NameField(editor, markers[index].name)) {
    editor->Do("marker.rename", {{"index", index}, {"name", *name}});
  }
  ImGui::Separator();
  if (ImGui::MenuItem(LabelOf("marker.remove"))) editor->Do("marker.remove", {{"index", index}});
  Tooltip(HelpOf("marker.remove"));
}

int MarkerUnder(const Editor& editor, const SheetFrame& frame, Point p) {
  const int sign = MarkerAt(editor.session(), frame, p);
  if (sign >= 0 || !frame.markers.Contains(p)) return sign;
  const std::vector<ProjectMarker>& markers = editor.session().project().markers;
  for (int i = static_cast<int>(markers.size()) - 1; i >= 0; --i) {  // the last lies on top
    const Rect name = MarkerName(markers[i], frame);
    const float width = std::min(name.w, ImGui::CalcTextSize(markers[i].name.c_str()).x);
    if (Rect{name.x, name.y, width, name.h}.Contains(p)) return i;
  }
  return -1;
}

}  // namespace hazumi::ui
