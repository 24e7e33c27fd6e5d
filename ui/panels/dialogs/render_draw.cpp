#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

struct Preset {
  int width, height;
  const char* name;
};

void DrawPresets(int* width, int* height) {
  static constexpr Preset kPresets[] = {{640, 360, ""},          {1280, 720, "HD"},
                                        {1920, 1080, "Full HD"}, {3840, 2160, "4K"},
                                        {1080, 1080, "1:1"},     {1080, 1920, "9:16"}};
  if (!ImGui::BeginCombo("##presets", Tr("Presets"), ImGuiComboFlags_NoPreview)) {
    return Tooltip(Tr("Usual sizes"));
  }
  for (const Preset& preset : kPresets) {
    const std::string size = std::to_string(preset.width) + " x " + std::to_string(preset.height);
    const bool is_now = preset.width == *width && preset.height == *height;
    if (!ListLine(size + "  " + preset.name, is_now)) continue;
    *width = preset.width;
    *height = preset.height;
  }
  ImGui::EndCombo();
}

void SetRange(const ProjectFrames& frames, RenderState* render) {
  render->whole = true;
  render->first = frames.first;
  render->last = frames.last;
}

void DrawRange(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  const Project& project = editor->session().project();
  ImGui::SetNextItemWidth(Px(*editor, 60));
  bool is_changed = ImGui::InputInt("##first", &render.first, 0);
  Tooltip(Tr("First frame"));
  ImGui::SameLine();
  ImGui::TextUnformatted("-");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Px(*editor, 60));
  is_changed |= ImGui::InputInt("##last", &render.last, 0);
  Tooltip(Tr("Last frame"));
  if (is_changed) render.whole = true;
  ImGui::SameLine();
  if (ImGui::Button(Tr("All"))) SetRange(project.frames, &render);
  Tooltip(Tr("All frames of the animation"));
  if (!project.preview) return;
  ImGui::SameLine();
  if (ImGui::Button(Tr("Preview range"))) SetRange(*project.preview, &render);
  Tooltip(Tr("The frames that are played"));
}

void DrawFrames(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  DrawFieldLabel(Tr("Frames"), *editor);
  const std::string now = std::to_string(std::lround(editor->session().frame()));
  if (ImGui::RadioButton((Tr("current: ") + now).c_str(), !render.whole)) render.whole = false;
  Tooltip(Tr("One picture, of the current frame"));
  DrawFieldLabel("", *editor);
  if (ImGui::RadioButton(Tr("range"), render.whole)) render.whole = true;
  Tooltip(Tr("A picture of each frame"));
  ImGui::SameLine();
  DrawRange(editor);
}

void DrawResult(const Editor& editor, const RenderJob& job, const Result<int>& result) {
  const std::string& video = job.task().video;
  const bool is_given_up = !result.ok() && result.error().code == ErrorCode::kInterrupted;
  if (is_given_up && !video.empty()) return ImGui::TextWrapped("%s", Tr("Nothing is left of it."));
  if (!result.ok()) return DrawError(result.error().ToString(), editor.theme());
  if (!video.empty()) return ImGui::TextWrapped(Tr("The video is in %s"), video.c_str());
  const char* folder = job.task().folder.c_str();
  if (result.value() == 1) return ImGui::TextWrapped(Tr("The picture is in %s"), folder);
  ImGui::TextWrapped(Tr("%d pictures are in %s"), result.value(), folder);
}

void DrawFolder(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  DrawFieldLabel(Tr("Folder"), *editor);
  const ImGuiStyle& style = ImGui::GetStyle();
  const char* choose = Tr("Choose...");
  const float button = ImGui::CalcTextSize(choose).x + 2.0f * style.FramePadding.x;
  ImGui::SetNextItemWidth(-(button + style.ItemSpacing.x));
  if (ImGui::InputText("##folder", &render.folder)) editor->NeedGlyphs(render.folder);
  Tooltip(Tr("Where the pictures go; it is made if it is not there"));
  ImGui::SameLine();
  if (ImGui::Button(choose)) OpenFolderDialog(editor);
}

// What will be written, and what will be lost.
void DrawSummary(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  const RenderTask task = OutlineOf(*editor);
  const std::string summary = SummaryOf(task);
  if (render.counted != summary) {
    render.counted = summary;
    render.num_existing = CountExisting(task);
  }
  ImGui::TextWrapped("%s", summary.c_str());
  if (render.num_existing == 0) return;
  char text[200];
  std::snprintf(text, sizeof text, Tr("%d of these files exist and will be overwritten."),
                render.num_existing);
  DrawError(text, editor->theme());
}

}  // namespace

void DrawSizeFields(const Editor& editor, int* width, int* height) {
  DrawFieldLabel(Tr("Size"), editor);
  ImGui::SetNextItemWidth(Px(editor, 80));
  ImGui::InputInt("##width", width, 0);
  Tooltip(Tr("Width in pixels"));
  ImGui::SameLine();
  ImGui::TextUnformatted("x");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Px(editor, 80));
  ImGui::InputInt("##height", height, 0);
  Tooltip(Tr("Height in pixels"));
  ImGui::SameLine();
  DrawPresets(width, height);
}

void DrawViewFields(const Editor& editor, bool* through_project_camera, bool* overlays) {
  DrawFieldLabel(Tr("Camera"), editor);
  const bool has_camera = editor.session().project().camera.has_value();
  bool& through = *through_project_camera;
  if (ImGui::RadioButton(Tr("as in the viewport"), !through)) through = false;
  Tooltip(Tr("Sees what the viewport sees"));
  ImGui::SameLine();
  ImGui::BeginDisabled(!has_camera);
  if (ImGui::RadioButton(Tr("the project's"), through && has_camera)) through = true;
  ImGui::EndDisabled();
  DrawFieldLabel(Tr("Overlays"), editor);
  ImGui::Checkbox(Tr("as in the viewport##overlays"), overlays);
  Tooltip(Tr("Draws paths, ghosts and marks into the pictures, too"));
}

void DrawRenderDialog(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  DrawSizeFields(*editor, &render.width, &render.height);
  DrawFrames(editor);
  DrawViewFields(*editor, &render.through_project_camera, &render.overlays);
  DrawFolder(editor);
  ImGui::Spacing();
  DrawSummary(editor);
  DrawError(render.error, editor->theme());
  ImGui::Spacing();
  const int clicked =
      DrawButtons(*editor, {{Tr("Render"), Tr("Draws the pictures.")}, {Tr("Cancel"), ""}});
  if (clicked == 0) StartRender(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) Close(editor);
}

void DrawProgress(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  RenderJob& job = *render.job;
  const std::optional<Result<int>> result = job.result();
  const std::string text = std::to_string(job.written()) + " / " + std::to_string(job.total());
  ImGui::ProgressBar(static_cast<float>(job.written()) / static_cast<float>(job.total()),
                     {-1.0f, 0.0f}, text.c_str());
  if (!result) {
    const RenderTask& task = job.task();
    const std::string& place = task.video.empty() ? task.folder : task.video;
    ImGui::TextDisabled("%s", job.is_cancelled() ? Tr("Ending...") : place.c_str());
    const bool wants_end =
        DrawButtons(*editor, {{Tr("Cancel"), Tr("Ends after the picture at hand.")}}) == 0;
    if (wants_end || IsEscapePressed(*editor)) job.Cancel();
    return;
  }
  DrawResult(*editor, job, *result);
  const bool has_video = result->ok() && !job.task().video.empty();
  if (DrawButtons(*editor, {{Tr("Close"), ""}}) < 0 && !IsEscapePressed(*editor)) return;
  if (has_video) editor->Say(Tr("Exported: ") + job.task().video);
  render.job.reset();
  Close(editor);
}

}  // namespace hazumi::ui
