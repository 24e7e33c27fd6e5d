#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <set>

#include "ui/panels/dialogs/export_summary.h"
#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

struct FormatChoice {
  std::optional<MotionFormat> format;  // none: MP4
  const char* label;
  const char* help;
};

const std::vector<FormatChoice>& Formats() {
  static const std::vector<FormatChoice> formats = {
      {MotionFormat::kGlb, "glTF, binary (.glb)",
       "Skeleton, meshes and animation in one file, for Blender, Unreal, Unity and the web"},
      {MotionFormat::kGltf, "glTF, text (.gltf)", "The same as text, which is larger"},
      {MotionFormat::kBvh, "BVH (.bvh)", "Skeleton and angles, for nearly every program"},
      {MotionFormat::kCsv, "Table (.csv)", "Angles and rates, a row for each frame"},
      {MotionFormat::kJson, "JSON (.json)", "Everything that was computed, for programs"},
      {std::nullopt, "Video (.mp4)", "Pictures of the animation as they are seen"}};
  return formats;
}

bool IsChosen(const FormatChoice& choice, const ExportState& state) {
  if (!choice.format) return state.is_video;
  return !state.is_video && *choice.format == state.settings.format;
}

void DrawFormat(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const auto shown = std::find_if(Formats().begin(), Formats().end(),
                                  [&](const FormatChoice& f) { return IsChosen(f, state); });
  DrawFieldLabel(Tr("Format"), *editor);
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##format", Tr(shown->label))) return Tooltip(Tr(shown->help));
  for (const FormatChoice& choice : Formats()) {
    const bool is_clicked = ListLine(Tr(choice.label), IsChosen(choice, state));
    Tooltip(Tr(choice.help));
    if (is_clicked) ChooseFormat(choice.format, &state);
  }
  ImGui::EndCombo();
}

// A field with a file's name, and a button that chooses one. True once a name was typed.
bool DrawFileField(const char* id, Editor* editor, std::string* path, void (*choose)(Editor*)) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const char* label = Tr("Choose...");
  const float button = ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x;
  ImGui::PushID(id);
  ImGui::SetNextItemWidth(-(button + style.ItemSpacing.x));
  if (ImGui::InputText("##file", path)) {
    editor->NeedGlyphs(*path);
    editor->dialogs.exporting.error.clear();
  }
  const bool is_typed = ImGui::IsItemDeactivatedAfterEdit();
  Tooltip(*path);
  ImGui::SameLine();
  if (ImGui::Button(label)) choose(editor);
  ImGui::PopID();
  return is_typed;
}

void DrawFile(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  DrawFieldLabel(Tr("File"), *editor);
  if (DrawFileField("written", editor, &state.path, OpenExportFileDialog)) TakeTypedPath(&state);
}

std::string RangeText(const char* label, const ProjectFrames& frames) {
  return std::string(label) + ": " + std::to_string(frames.first) + " - " +
         std::to_string(frames.last);
}

void DrawOwnRange(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  ImGui::SetNextItemWidth(Px(*editor, 60));
  bool is_changed = ImGui::InputInt("##first", &state.first, 0);
  Tooltip(Tr("First frame"));
  ImGui::SameLine();
  ImGui::TextUnformatted("-");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Px(*editor, 60));
  is_changed |= ImGui::InputInt("##last", &state.last, 0);
  Tooltip(Tr("Last frame"));
  if (is_changed) state.range = ExportRange::kFromTo;
}

void DrawRange(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const Project& project = editor->session().project();
  ExportRange& range = state.range;
  if (range == ExportRange::kPreview && !project.preview) range = ExportRange::kAll;
  DrawFieldLabel(Tr("Frames"), *editor);
  const std::string all = RangeText(Tr("all"), project.frames);
  if (ImGui::RadioButton(all.c_str(), range == ExportRange::kAll)) range = ExportRange::kAll;
  Tooltip(Tr("All frames of the animation"));
  ImGui::SameLine();
  if (project.preview) {
    const std::string preview = RangeText(Tr("preview"), *project.preview);
    const bool is_preview = range == ExportRange::kPreview;
    if (ImGui::RadioButton(preview.c_str(), is_preview)) range = ExportRange::kPreview;
    Tooltip(Tr("The frames that are played"));
    ImGui::SameLine();
  }
  if (ImGui::RadioButton(Tr("from"), range == ExportRange::kFromTo)) range = ExportRange::kFromTo;
  ImGui::SameLine();
  DrawOwnRange(editor);
}

template <typename T>
void DrawChoice(const char* label, const char* help, T value, T* chosen) {
  if (ImGui::RadioButton(label, *chosen == value)) *chosen = value;
  Tooltip(help);
}

void DrawBvh(Editor* editor) {
  edit::ExportSettings& settings = editor->dialogs.exporting.settings;
  DrawFieldLabel(Tr("Up"), *editor);
  DrawChoice("y", Tr("As Blender, Maya, MotionBuilder and Unreal read BVH"), UpAxis::kY,
             &settings.up);
  ImGui::SameLine();
  DrawChoice("z", Tr("Hazumi's own axes"), UpAxis::kZ, &settings.up);
  DrawFieldLabel(Tr("Unit"), *editor);
  DrawChoice(Tr("centimetres"), Tr("As nearly all BVH files are; set Blender's scale to 0.01"),
             0.01, &settings.metres_per_unit);
  ImGui::SameLine();
  DrawChoice(Tr("metres"), Tr("As Blender reads BVH unless it is told a scale"), 1.0,
             &settings.metres_per_unit);
}

void DrawSkin(Editor* editor) {
  using edit::ExportSkin;
  ExportSkin& skin = editor->dialogs.exporting.settings.skin;
  DrawFieldLabel(Tr("Skin"), *editor);
  if (editor->session().project().skin) {
    DrawChoice(Tr("character"), Tr("The meshes it came with"), ExportSkin::kCharacter, &skin);
    ImGui::SameLine();
  }
  DrawChoice(Tr("capsules"), Tr("The figure as it is seen without a character"),
             ExportSkin::kCapsules, &skin);
  ImGui::SameLine();
  DrawChoice(Tr("none##skin"), Tr("The skeleton alone"), ExportSkin::kNone, &skin);
}

// True if the motion is put into the file that the figure came from: what else there is to choose
// is as it is there.
bool DrawOnto(Editor* editor) {
  if (!MayBeOnto(*editor)) return false;
  ExportState& state = editor->dialogs.exporting;
  DrawFieldLabel(Tr("Into"), *editor);
  if (ImGui::Checkbox(Tr("the file it was imported from"), &state.is_onto) && state.is_onto)
    TakeOnto(&state);
  Tooltip(Tr("That file with the bones that have changed; all else stays as it is there"));
  if (!state.is_onto) return false;
  DrawFieldLabel(Tr("Imported from"), *editor);
  if (DrawFileField("onto", editor, &state.onto, OpenOntoFileDialog)) TakeOnto(&state);
  return true;
}

void DrawOptions(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  DrawFormat(editor);
  DrawFile(editor);
  DrawRange(editor);
  if (state.is_video) {
    DrawSizeFields(*editor, &state.width, &state.height);
    DrawViewFields(*editor, &state.through_project_camera, &state.overlays);
  } else if (DrawOnto(editor)) {
    return;
  } else if (state.settings.format == MotionFormat::kBvh) {
    DrawBvh(editor);
  } else if (HasMeshes(state)) {
    DrawSkin(editor);
  } else if (HasTorques(state.settings.format)) {
    ImGui::Checkbox(Tr("Torques"), &state.settings.torques);
    Tooltip(Tr("Also the torque that every joint needs, and the force that nothing supplies"));
  }
}

// Each letter of a valid text that is not ASCII once, so that equal alphabets are equal texts.
std::string ForeignLetters(const std::string& text) {
  const auto is_inside = [&](size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  std::set<std::string> letters;
  for (size_t i = 0; i < text.size();) {
    size_t end = i + 1;
    while (is_inside(end)) ++end;
    if (end > i + 1) letters.insert(text.substr(i, end - i));
    i = end;
  }
  std::string all;
  for (const std::string& letter : letters) all += letter;
  return all;
}

void DrawFacts(Editor* editor, const ExportSummary* summary) {
  for (const std::string& fact : ExportFacts(*editor, summary))
    ImGui::TextWrapped("%s", fact.c_str());
  std::string left_out;
  for (const std::string& part : LeftOut(*editor, summary))
    left_out += (left_out.empty() ? "" : Tr(", ")) + part;
  editor->NeedGlyphs(ForeignLetters(left_out));
  if (!left_out.empty()) DrawError(Tr("Not written: ") + left_out, editor->theme());
}

// As much of a value as is read at a glance.
std::string Short(const std::string& value) {
  constexpr size_t kLongest = 11;
  return value.size() <= kLongest ? value : value.substr(0, kLongest - 1) + "..";
}

// A line for each column of the file: its name, then what it says in the first rows.
void DrawColumns(const std::vector<std::vector<std::string>>& columns) {
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_BordersInnerV;
  const int width = static_cast<int>(columns.front().size());
  if (!ImGui::BeginTable("##columns", width, kFlags)) return;
  for (const std::vector<std::string>& column : columns) {
    ImGui::TableNextRow();
    for (size_t i = 0; i < column.size(); ++i) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted((i == 0 ? column[i] : Short(column[i])).c_str());
    }
  }
  ImGui::EndTable();
}

void DrawContents(Editor* editor, const ExportSummary& summary, float bottom) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ToIm4(editor->theme().row_odd));
  ImGui::BeginChild("##contents", {0.0f, -bottom}, true, ImGuiWindowFlags_HorizontalScrollbar);
  if (!summary.columns.empty()) {
    DrawColumns(summary.columns);
  } else {
    ImGui::TextUnformatted(summary.head.c_str());
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

// What there is to say about the preview, and the preview.
void DrawPreview(Editor* editor, float bottom) {
  const ExportState& state = editor->dialogs.exporting;
  const std::string trouble = ExportTrouble(*editor);
  if (!trouble.empty()) return DrawError(trouble, editor->theme());
  if (state.is_video) return DrawFacts(editor, nullptr);
  const bool is_baking =
      state.source_error && editor->session().bake() && editor->session().bake()->is_busy();
  if (is_baking) return ImGui::TextDisabled("%s", Tr("The motion is being computed..."));
  if (state.source_error) return DrawError(state.source_error->ToString(), editor->theme());
  const Result<ExportedFile>* file = CurrentPreview(*editor);
  if (!file) return ImGui::TextDisabled("%s", Tr("Preparing..."));
  if (!file->ok()) return DrawError(file->error().ToString(), editor->theme());
  const ExportSummary& summary = file->value().summary;
  std::string shown = summary.head;
  for (const std::vector<std::string>& column : summary.columns) shown += column.front();
  editor->NeedGlyphs(ForeignLetters(shown));
  DrawFacts(editor, &summary);
  DrawContents(editor, summary, bottom);
}

void DrawOverwrite(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  DrawError(NameIn(ExportPath(state)) + ": " + Tr("this file exists already."), editor->theme());
  const int clicked =
      DrawButtons(*editor, {{Tr("Overwrite"), Tr("Writes in its place.")}, {Tr("Cancel"), ""}});
  if (clicked == 0) ConfirmExport(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) state.asks_overwrite = false;
}

void DrawWriting(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  // Two steps: what is written is made, then it is written.
  ImGui::ProgressBar(state.write ? 0.5f : 0.0f, {-1.0f, 0.0f},
                     state.write ? Tr("Writing...") : Tr("Preparing..."));
  const bool wants_end = ImGui::Button(Tr("Cancel"));  // not by the Enter that began it
  Tooltip(Tr("Nothing is written."));
  if (wants_end || IsEscapePressed(*editor)) CancelExport(&state);
}

void DrawBottom(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  if (state.asks_overwrite) return DrawOverwrite(editor);
  if (state.wants_write || state.write) return DrawWriting(editor);
  DrawError(state.error, editor->theme());
  const int clicked =
      DrawButtons(*editor, {{Tr("Export"), Tr("Writes the file.")}, {Tr("Cancel"), ""}});
  if (clicked == 0) StartExport(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) CloseExport(editor);
}

// Of what DrawBottom draws [px].
float BottomHeight(const ExportState& state) {
  const float row = ImGui::GetFrameHeightWithSpacing(), space = ImGui::GetStyle().ItemSpacing.y;
  if (state.asks_overwrite) return row + space + ImGui::GetTextLineHeightWithSpacing();
  if (state.wants_write || state.write) return 2.0f * row + space;
  if (state.error.empty()) return row + space;
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string text = "! " + state.error;
  return row + 2.0f * space + ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
}

}  // namespace

void DrawExport(Editor* editor) {
  RefreshExport(editor);
  const ExportState& state = editor->dialogs.exporting;
  if (editor->dialogs.modal != Modal::kExport) return;
  ImGui::BeginDisabled(state.wants_write || state.write || state.asks_overwrite);
  DrawOptions(editor);
  ImGui::EndDisabled();
  ImGui::Spacing();
  const float bottom = BottomHeight(state);
  const float end = ImGui::GetWindowHeight() - bottom - ImGui::GetStyle().WindowPadding.y;
  DrawPreview(editor, bottom);
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), end));
  DrawBottom(editor);
}

}  // namespace hazumi::ui
