// Small windows over the sheets: interpolation, handles, keys, and what bars stand for.

#include "ui/panels/sheet/popups.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/commands/actions.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/sheet/key_kinds.h"
#include "ui/panels/text/quantity_text.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

const char* IdOf(SheetPopup popup) {
  switch (popup) {
    case SheetPopup::kInterpolation:
      return "##interpolation";
    case SheetPopup::kHandles:
      return "##handles";
    case SheetPopup::kKeyType:
      return "##key_type";
    case SheetPopup::kBar:
      return "##bar";
    case SheetPopup::kKeys:
      return "##keys";
    case SheetPopup::kMarker:
      return "##marker";
    case SheetPopup::kNone:
      break;
  }
  return "";
}

void Title(const char* text) {
  ImGui::TextDisabled("%s", text);
  ImGui::Separator();
}

void Item(Editor* editor, const char* label, const char* id, const Json& parameters,
          bool is_enabled = true) {
  const std::string key = KeyOf(id, parameters);
  if (ImGui::MenuItem(label, key.empty() ? nullptr : key.c_str(), false, is_enabled)) {
    editor->Do(id, parameters);
  }
  Tooltip(HelpOf(id));
}

void ChoiceItems(Editor* editor, const std::vector<KeyChoice>& choices) {
  for (const KeyChoice& choice : choices) {
    if (choice.begins_group) ImGui::Separator();
    Item(editor, Tr(choice.label), choice.id, choice.parameters);
  }
}

void ChoiceMenu(Editor* editor, const char* label, const std::vector<KeyChoice>& choices,
                bool is_enabled) {
  if (!ImGui::BeginMenu(label, is_enabled)) return;
  ChoiceItems(editor, choices);
  ImGui::EndMenu();
}

void KeyItems(Editor* editor) {
  const bool has_keys = !editor->session().selected_keys().empty();
  const bool has_bar = ChosenBar(editor->session().project(), editor->sheet).has_value();
  const bool has_copy = !editor->session().key_clipboard().empty();
  Item(editor, LabelOf("keys.copy"), "keys.copy", Json::object(), has_keys);
  Item(editor, LabelOf("keys.paste"), "keys.paste", Json::object(), has_copy);
  Item(editor, LabelOf("sheet.delete"), "sheet.delete", Json::object(), has_keys || has_bar);
  ImGui::Separator();
  ChoiceMenu(editor, Tr("Interpolation"), InterpolationChoices(), has_keys);
  ChoiceMenu(editor, Tr("Handles"), HandleChoices(), has_keys);
  ChoiceMenu(editor, Tr("Key type"), KeyTypeChoices(), has_keys);
  ImGui::Separator();
  Item(editor, LabelOf("sheet.mark_region"), "sheet.mark_region", Json::object());
  for (const char* id : {"span.hold", "span.pin", "span.gravity"}) {
    Item(editor, LabelOf(id), id, Json::object());
  }
  ImGui::Separator();
  Item(editor, LabelOf("sheet.frame_all"), "sheet.frame_all", Json::object());
}

// The one whose bar was clicked.
const ProjectRegion* ChosenRegion(const Editor& editor) {
  const Project& project = editor.session().project();
  const std::optional<BarRef> bar = ChosenBar(project, editor.sheet);
  return bar && bar->kind == BarKind::kRegion ? &project.regions[bar->index] : nullptr;
}

void FrictionSlider(Editor* editor, const ProjectRegion& region) {
  auto factor = static_cast<float>(region.friction.default_factor);
  const std::string name = region.name;
  if (ImGui::SliderFloat("##friction", &factor, 0.0f, 1.0f, "%.2f")) {
    const double rounded = std::round(100.0 * factor) / 100.0;
    editor->Do("region.friction",
               {{"region", name}, {"factor", rounded}, {"drag", "sheet friction"}});
  }
  if (ImGui::IsItemDeactivated()) editor->Do("edit.end_drag");
  Tooltip(Tr("Speed that is left after 1/30 s: 0 frozen, 1 no friction"));
}

void BlendSlider(Editor* editor, const ProjectRegion& region) {
  int frames = region.blend_frames;
  const std::string name = region.name;
  if (ImGui::SliderInt("##blend", &frames, 0, 30, Tr("%d frames"))) {
    editor->Do("region.set", {{"region", name}, {"blend", frames}, {"drag", "sheet blend"}});
  }
  if (ImGui::IsItemDeactivated()) editor->Do("edit.end_drag");
  Tooltip(Tr("frames in which joints come back to their keys after it"));
}

void MuteItem(Editor* editor, bool is_muted) {
  if (ImGui::MenuItem(Tr("Mute"), KeyOf("sheet.mute", Json::object()).c_str(), is_muted)) {
    editor->Do("sheet.mute");
  }
  Tooltip(HelpOf("sheet.mute"));
}

// Removes the joints of the row on which the bar was clicked from the region.
void TakeOutItem(Editor* editor, const ProjectRegion& region) {
  const std::vector<SheetRow> rows = SheetRows(editor->session(), editor->sheet);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const SheetRow& each) {
    return each.id == editor->sheet.bar_row && !each.refs.empty();
  });
  if (row == rows.end()) return;
  const std::string label = std::string(Tr("Take out")) + ": " + row->name;
  Item(editor, label.c_str(), "region.remove_joints",
       {{"region", region.name}, {"joints", row->refs}});
}

void RegionItems(Editor* editor) {
  const ProjectRegion* region = ChosenRegion(*editor);
  if (!region) return ImGui::CloseCurrentPopup();
  Title(Tr("Dynamics region"));
  ImGui::PushItemWidth(12.0f * ImGui::GetFontSize());
  ImGui::TextUnformatted(Tr("Name"));
  if (const auto name = NameField(editor, region->name)) {
    editor->Do("region.set", {{"region", region->name}, {"name", *name}});
  }
  region = ChosenRegion(*editor);
  if (region) {
    ImGui::TextUnformatted(Tr("Friction: speed left"));
    FrictionSlider(editor, *region);
    ImGui::TextDisabled("%s", FrictionInWords(region->friction.default_factor).c_str());
    ImGui::TextUnformatted(Tr("Blend"));
    BlendSlider(editor, *region);
  }
  ImGui::PopItemWidth();
  region = ChosenRegion(*editor);
  if (!region) return;
  ImGui::Separator();
  const std::string name = region->name;
  const int now = static_cast<int>(std::lround(editor->session().frame()));
  const bool is_inside = now > region->first_frame && now < region->last_frame;
  MuteItem(editor, region->mute);
  TakeOutItem(editor, *region);
  Item(editor, Tr("Split at the playhead"), "region.split", {{"region", name}, {"frame", now}},
       is_inside);
  Item(editor, LabelOf("region.to_keys"), "region.to_keys", {{"region", name}});
  Item(editor, LabelOf("region.remove"), "region.remove", {{"region", name}});
}

void BarItems(Editor* editor) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  if (!bar) return ImGui::CloseCurrentPopup();
  if (bar->kind == BarKind::kRegion) return RegionItems(editor);
  const BarTexts& texts = TypeOf(bar->kind).texts;
  Title(Tr(texts.title));
  ImGui::Dummy({18.0f * ImGui::GetFontSize(), 0.0f});
  DrawSpanFields(editor);
  ImGui::Separator();
  if (ImGui::MenuItem(LabelOf(texts.remove), KeyOf("sheet.delete", Json::object()).c_str())) {
    (void)RemoveChosenBar(editor);
  }
  Tooltip(HelpOf(texts.remove));
}

void Items(Editor* editor, SheetPopup popup) {
  switch (popup) {
    case SheetPopup::kInterpolation:
      Title(Tr("Interpolation"));
      return ChoiceItems(editor, InterpolationChoices());
    case SheetPopup::kHandles:
      Title(Tr("Handles"));
      return ChoiceItems(editor, HandleChoices());
    case SheetPopup::kKeyType:
      Title(Tr("Key type"));
      return ChoiceItems(editor, KeyTypeChoices());
    case SheetPopup::kBar:
      return BarItems(editor);
    case SheetPopup::kKeys:
      return KeyItems(editor);
    case SheetPopup::kMarker:
      return DrawMarkerItems(editor);
    case SheetPopup::kNone:
      break;
  }
}

}  // namespace

void DrawSheetPopups(Editor* editor) {
  SheetPopup& wanted = editor->sheet.popup;
  if (wanted != SheetPopup::kNone) ImGui::OpenPopup(IdOf(wanted));
  wanted = SheetPopup::kNone;
  using enum SheetPopup;
  for (const SheetPopup popup : {kInterpolation, kHandles, kKeyType, kBar, kKeys, kMarker}) {
    if (!ImGui::BeginPopup(IdOf(popup))) continue;
    Items(editor, popup);
    ImGui::EndPopup();
  }
}

// ImGui keeps what is typed as long as it is.
std::optional<std::string> NameField(Editor* editor, const std::string& name) {
  std::string typed = name;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputText(
      "##name", &typed, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) editor->NeedGlyphs(typed);
  const bool is_done = is_entered || ImGui::IsItemDeactivatedAfterEdit();
  if (is_entered) ImGui::CloseCurrentPopup();
  if (!is_done || typed.empty() || typed == name) return std::nullopt;
  return typed;
}

}  // namespace hazumi::ui
