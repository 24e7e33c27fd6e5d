#include <imgui.h>

#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

// A character that was chosen instead.
std::optional<std::string> DrawCharacters(const Editor& editor, const Character& character) {
  if (character.others.empty()) return std::nullopt;
  ImGui::TextWrapped("%s", Tr("The file has several characters: choose one of the list."));
  DrawFieldLabel(Tr("Character"), editor);
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##character", character.chosen.c_str())) return std::nullopt;
  std::optional<std::string> chosen;
  for (size_t i = 0; i < character.others.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ListLine(character.others[i], false)) chosen = character.others[i];
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return chosen;
}

// True if another clip was chosen.
bool DrawClips(const Editor& editor, const Character& character, ImportOptions* options) {
  if (character.clips.empty()) return false;
  if (character.clips.size() > 1) {
    ImGui::TextWrapped("%s", Tr("The file has several clips: choose one of the list."));
  }
  DrawFieldLabel(Tr("Clip"), editor);
  const std::string& now = options->clip;
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##clip", now.c_str())) return false;
  bool is_changed = false;
  for (size_t i = 0; i < character.clips.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const Clip& clip = character.clips[i];
    const std::string length = "   " + std::to_string(clip.num_frames) + " " + Tr("frames");
    if (ListLine(clip.name + length, clip.name == now)) {
      options->clip = clip.name;
      is_changed = true;
    }
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return is_changed;
}

bool DrawUp(const Editor& editor, ImportOptions* options) {
  DrawFieldLabel(Tr("Up"), editor);
  const std::optional<UpAxis> before = options->up;
  if (ImGui::RadioButton(Tr("as the file says"), !options->up)) options->up.reset();
  Tooltip(Tr("Guessed where the file says nothing"));
  ImGui::SameLine();
  if (ImGui::RadioButton("y", options->up == UpAxis::kY)) options->up = UpAxis::kY;
  ImGui::SameLine();
  if (ImGui::RadioButton("z", options->up == UpAxis::kZ)) options->up = UpAxis::kZ;
  return options->up != before;
}

// A positive number, or 0, which reads "automatic": not given. True once it was typed.
bool DrawMaybe(const Editor& editor, const char* id, const char* label, const char* format,
               const char* help, double* value) {
  DrawFieldLabel(label, editor);
  ImGui::SetNextItemWidth(Px(editor, 90));
  ImGui::InputDouble(id, value, 0.0, 0.0, *value > 0.0 ? format : Tr("automatic"));
  const bool is_changed = ImGui::IsItemDeactivatedAfterEdit();
  Tooltip(help);
  *value = std::max(*value, 0.0);
  return is_changed;
}

// True if other frames of the clip are to be taken.
bool DrawRate(const Editor& editor, ImportState* state) {
  return DrawMaybe(editor, "##fps", Tr("Frames a second"), "%.3f",
                   Tr("Of the clip; the motion is the same; 0: as the file has them"), &state->fps);
}

bool DrawKeys(const Editor& editor, ImportState* state) {
  DrawFieldLabel(Tr("Keys"), editor);
  bool is_changed = ImGui::Checkbox(Tr("few, within"), &state->reduces);
  Tooltip(Tr("Keys only where they are needed, instead of one a frame"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Px(editor, 60));
  ImGui::BeginDisabled(!state->reduces);
  ImGui::InputDouble("##reduce", &state->reduce_deg, 0.0, 0.0, "%.2f");
  is_changed |= ImGui::IsItemDeactivatedAfterEdit();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::TextUnformatted(Tr("degrees"));
  state->reduce_deg = std::clamp(state->reduce_deg, 0.01, 90.0);
  return is_changed;
}

bool DrawRest(const Editor& editor, const Character& character, ImportOptions* options) {
  DrawFieldLabel(Tr("Limits"), editor);
  const ImportLimits before = options->limits;
  const bool is_clip = before == ImportLimits::kClip;
  if (ImGui::RadioButton(Tr("of the clip"), is_clip)) options->limits = ImportLimits::kClip;
  Tooltip(Tr("A body's joints go as far as people's, others a little farther than in the clip"));
  ImGui::SameLine();
  if (ImGui::RadioButton(Tr("none"), !is_clip)) options->limits = ImportLimits::kNone;
  bool is_changed = options->limits != before;
  DrawFieldLabel(Tr("Hinges"), editor);
  bool is_body = options->hinges == ImportHinges::kBody;
  if (ImGui::Checkbox(Tr("of a body"), &is_body)) {
    options->hinges = is_body ? ImportHinges::kBody : ImportHinges::kFile;
    is_changed = true;
  }
  Tooltip(Tr("Arms, legs, spine and head turn about a body's axes: for throws, jumps and poses"));
  if (character.meshes.empty()) return is_changed;
  DrawFieldLabel(Tr("Skin"), editor);
  is_changed |= ImGui::Checkbox(Tr("keep its meshes"), &options->skin);
  return is_changed;
}

bool DrawOptions(Editor* editor, const Character& character) {
  ImportState& state = editor->dialogs.import;
  bool is_changed = DrawClips(*editor, character, &state.options);
  is_changed |= DrawUp(*editor, &state.options);
  is_changed |=
      DrawMaybe(*editor, "##height", Tr("Height (m)"), "%.3f",
                Tr("How tall it shall be; 0: as the file says, or guessed"), &state.height_m);
  is_changed |= DrawMaybe(*editor, "##mass", Tr("Mass (kg)"), "%.1f",
                          Tr("Of all of it; 0: of a person so tall"), &state.mass_kg);
  is_changed |= DrawKeys(*editor, &state);
  is_changed |= DrawRest(*editor, character, &state.options);
  return DrawRoles(*editor, &state) || is_changed;
}

void DrawReport(const Editor& editor, const Result<Imported>& imported) {
  if (!imported.ok()) return DrawError(imported.error().ToString(), editor.theme());
  ImGui::BeginChild("##report", {0.0f, Px(editor, 170)}, true);
  const ImportReport& report = imported.value().report;
  for (const std::string& fact : report.facts) ImGui::TextWrapped("%s", fact.c_str());
  for (const Warning& warning : report.warnings) {
    const std::string place = warning.place.empty() ? "" : warning.place + ": ";
    DrawError(place + warning.message, editor.theme());
  }
  ImGui::EndChild();
}

void DrawReading(Editor* editor) {
  ImGui::TextDisabled("%s", Tr("Reading..."));
  const int clicked = DrawButtons(*editor, {{Tr("Cancel"), ""}});
  if (clicked < 0 && !IsEscapePressed(*editor)) return;
  editor->dialogs.import = {};
  Close(editor);
}

}  // namespace

void DrawImport(Editor* editor) {
  ImportState& state = editor->dialogs.import;
  ImGui::TextWrapped("%s", state.job->path().c_str());
  ImGui::Spacing();
  const Result<Character>* character = state.job->character();
  if (!character) return DrawReading(editor);
  if (character->ok()) {
    if (const auto chosen = DrawCharacters(*editor, character->value()))
      return ChooseCharacter(*chosen, &state);
    if (!character->value().clips.empty() && DrawRate(*editor, &state)) return ChooseRate(&state);
  }
  const bool is_changed = character->ok() && DrawOptions(editor, character->value());
  if (is_changed || !state.imported) RefreshImport(&state);
  ImGui::Spacing();
  DrawReport(*editor, *state.imported);
  ImGui::Spacing();
  const bool can_import = state.imported->ok();
  int clicked = -1;
  if (can_import) {
    clicked = DrawButtons(*editor,
                          {{Tr("Import"), Tr("Makes a new project of it.")}, {Tr("Cancel"), ""}});
  } else if (DrawButtons(*editor, {{Tr("Close"), ""}}) == 0) {
    clicked = 1;
  }
  if (clicked == 0) return FinishImport(editor);
  if (clicked != 1 && !IsEscapePressed(*editor)) return;
  state = {};
  Close(editor);
}

}  // namespace hazumi::ui
