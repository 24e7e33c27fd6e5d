// Language, theme, scale, and the keys of the keyboard.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "ui/panels/commands/menus.h"
#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

std::string LabelOf(const Shortcut& shortcut) {
  for (const MenuEntry& entry : FlatMenus()) {
    if (std::string(shortcut.id) == entry.id && shortcut.parameters == entry.parameters) {
      return LabelOf(entry);
    }
  }
  constexpr std::pair<const char*, const char*> kPopups[] = {
      {"interpolation", "Interpolation"}, {"handles", "Handles"}, {"key_type", "Key type"}};
  for (const auto& [popup, label] : kPopups) {
    if (shortcut.parameters.value("popup", "") == popup) return Tr(label);
  }
  const std::string id = shortcut.id;
  const bool is_none = id == "keys.select" || id == "select.joints";  // of an empty list
  return is_none ? Tr("Select none") : LabelOf(std::string(shortcut.id));
}

namespace {

struct Choice {
  const char* label;
  const char* id;
  Json parameters;
  bool is_on;
};

void DrawChoices(Editor* editor, const char* label, const std::vector<Choice>& choices) {
  DrawFieldLabel(label, *editor);
  for (const Choice& choice : choices) {
    if (ImGui::RadioButton(choice.label, choice.is_on)) editor->Do(choice.id, choice.parameters);
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void DrawLook(Editor* editor) {
  const Settings& settings = editor->settings;
  const bool is_japanese = settings.language == Language::kJapanese;
  DrawChoices(editor, Tr("Language"),
              {{"English", "view.language", {{"language", "en"}}, !is_japanese},
               {"日本語", "view.language", {{"language", "ja"}}, is_japanese}});
  DrawChoices(editor, Tr("Theme"),
              {{Tr("Dark"), "view.theme", {{"dark", true}}, settings.dark},
               {Tr("Light"), "view.theme", {{"dark", false}}, !settings.dark}});
  const auto scale = [&](const char* name, double value) {
    return Choice{name, "view.scale", {{"scale", value}}, settings.scale == value};
  };
  DrawChoices(
      editor, Tr("Interface scale"),
      {scale("100 %", 1.0), scale("125 %", 1.25), scale("150 %", 1.5), scale("200 %", 2.0)});
}

bool HasPart(const std::string& text, const std::string& part) {
  const auto equal = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), equal) != text.end();
}

// Esc leaves it as it is, Backspace takes the key away.
void TakeKey(Editor* editor, const Shortcut& by_default) {
  int& waits = editor->dialogs.preferences.waits;
  editor->dialogs.takes_enter = editor->dialogs.takes_arrows = true;
  for (const Chord& chord : PressedKeys(false)) {
    waits = -1;
    if (chord.key == kEscape) return;
    const std::string to = chord.key == kBackspace ? "" : NameOf(chord);
    editor->Do(
        "keymap.set",
        {{"place", NameOf(by_default.place)}, {"key", NameOf(by_default.chord)}, {"to", to}});
    return;
  }
}

void DrawKey(Editor* editor, int index) {
  const Shortcut& by_default = DefaultShortcuts()[index];
  const Chord now = AllShortcuts()[index].chord;
  PreferencesState& state = editor->dialogs.preferences;
  ImGui::PushID(index);
  const bool waits = state.waits == index;
  const std::string name = waits ? Tr("Press a key") : NameOf(now);
  if (ImGui::Button((name + "##key").c_str(), {-1.0f, 0.0f})) state.waits = waits ? -1 : index;
  Tooltip(Tr("Click, then press the new key. Esc: as it is. Backspace: no key."));
  ImGui::TableNextColumn();
  if (now != by_default.chord) {
    if (ImGui::SmallButton(NameOf(by_default.chord).c_str())) {
      editor->Do("keymap.set",
                 {{"place", NameOf(by_default.place)}, {"key", NameOf(by_default.chord)}});
    }
    Tooltip(Tr("Back to this key"));
  }
  ImGui::PopID();
}

void DrawKeys(Editor* editor) {
  PreferencesState& state = editor->dialogs.preferences;
  const float bottom = 1.3f * ImGui::GetFrameHeightWithSpacing();
  if (!ImGui::BeginTable("##keymap", 4, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg,
                         {0.0f, -bottom})) {
    return;
  }
  ImGui::TableSetupColumn("##what", ImGuiTableColumnFlags_WidthStretch, 3.0f);
  ImGui::TableSetupColumn("##where", ImGuiTableColumnFlags_WidthStretch, 1.2f);
  ImGui::TableSetupColumn("##key", ImGuiTableColumnFlags_WidthStretch, 1.6f);
  ImGui::TableSetupColumn("##default", ImGuiTableColumnFlags_WidthStretch, 1.2f);
  const std::vector<Shortcut>& all = DefaultShortcuts();
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const std::string label = LabelOf(all[i]);
    const std::string key = NameOf(AllShortcuts()[i].chord);
    if (!HasPart(label, state.filter) && !HasPart(key, state.filter)) continue;
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", LabelOf(all[i].place));
    ImGui::TableNextColumn();
    DrawKey(editor, i);
  }
  ImGui::EndTable();
}

}  // namespace

const char* LabelOf(Place place) {
  switch (place) {
    case Place::kViewport:
      return Tr("Viewport");
    case Place::kSheet:
      return Tr("Sheets");
    case Place::kAnywhere:
      break;
  }
  return Tr("Everywhere");
}

void DrawPreferences(Editor* editor) {
  PreferencesState& state = editor->dialogs.preferences;
  const bool waited = state.waits >= 0;
  if (waited && !editor->dialogs.just_opened) TakeKey(editor, DefaultShortcuts()[state.waits]);
  DrawLook(editor);
  ImGui::Spacing();
  DrawFieldLabel(Tr("Keys"), *editor);
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##filter", Tr("What it does, or a key"), &state.filter);
  DrawKeys(editor);
  const int clicked =
      DrawButtons(*editor, {{Tr("Close"), ""}, {Tr("All as by default"), HelpOf("keymap.reset")}});
  if (clicked == 1) editor->Do("keymap.reset");
  if (waited || (clicked != 0 && !IsEscapePressed(*editor))) return;
  state = {};
  Close(editor);
}

}  // namespace hazumi::ui
