#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "ui/panels/dialogs_parts.h"

namespace hazumi::ui {

namespace {

void Label(const char* text, const Editor& editor) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(Px(editor, 130));
}

void DrawSize(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  Label(Tr("Size"), *editor);
  ImGui::SetNextItemWidth(Px(*editor, 80));
  ImGui::InputInt("##width", &render.width, 0);
  Tooltip(Tr("Width in pixels"));
  ImGui::SameLine();
  ImGui::TextUnformatted("x");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(Px(*editor, 80));
  ImGui::InputInt("##height", &render.height, 0);
  Tooltip(Tr("Height in pixels"));
}

void DrawFrames(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  Label(Tr("Frames"), *editor);
  const std::string now = std::to_string(std::lround(editor->session().frame()));
  const ProjectFrames& all = editor->session().project().frames;
  const std::string range = std::to_string(all.first) + " - " + std::to_string(all.last);
  if (ImGui::RadioButton((Tr("current: ") + now).c_str(), !render.whole)) render.whole = false;
  Tooltip(Tr("One picture, of the current frame"));
  ImGui::SameLine();
  if (ImGui::RadioButton((Tr("all: ") + range).c_str(), render.whole)) render.whole = true;
  Tooltip(Tr("A picture of each frame"));
}

void DrawView(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  Label(Tr("Camera"), *editor);
  const bool has_camera = editor->session().project().camera.has_value();
  bool& through = render.through_project_camera;
  if (ImGui::RadioButton(Tr("as in the viewport"), !through)) through = false;
  Tooltip(Tr("Sees what the viewport sees"));
  ImGui::SameLine();
  ImGui::BeginDisabled(!has_camera);
  if (ImGui::RadioButton(Tr("the project's"), through && has_camera)) through = true;
  ImGui::EndDisabled();
  Label(Tr("Overlays"), *editor);
  ImGui::Checkbox(Tr("as in the viewport##overlays"), &render.overlays);
  Tooltip(Tr("Draws paths, ghosts and marks into the pictures, too"));
}

void DrawResult(const Editor& editor, const RenderJob& job, const Result<int>& result) {
  if (!result.ok()) return DrawError(result.error().ToString(), editor.theme());
  const char* folder = job.task().folder.c_str();
  if (result.value() == 1) return ImGui::TextWrapped(Tr("The picture is in %s"), folder);
  ImGui::TextWrapped(Tr("%d pictures are in %s"), result.value(), folder);
}

}  // namespace

void DrawRenderDialog(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  DrawSize(editor);
  DrawFrames(editor);
  DrawView(editor);
  Label(Tr("Folder"), *editor);
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::InputText("##folder", &render.folder)) editor->NeedGlyphs(render.folder);
  Tooltip(Tr("Where the pictures go; it is made if it is not there"));
  DrawError(render.error, editor->theme());
  ImGui::Spacing();
  const int clicked = DrawButtons(*editor, {{Tr("Render"), Tr("Draws the pictures.")},
                                            {Tr("Cancel"), Tr("Leaves everything as it is.")}});
  if (clicked == 0) StartRender(editor);
  if (clicked == 1 || IsEscapePressed()) Close(editor);
}

void DrawProgress(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  RenderJob& job = *render.job;
  const std::optional<Result<int>> result = job.result();
  const std::string text = std::to_string(job.written()) + " / " + std::to_string(job.total());
  ImGui::ProgressBar(static_cast<float>(job.written()) / static_cast<float>(job.total()),
                     {-1.0f, 0.0f}, text.c_str());
  if (!result) {
    ImGui::TextDisabled("%s", job.is_cancelled() ? Tr("Ending...") : job.task().folder.c_str());
    const bool wants_end =
        DrawButtons(*editor, {{Tr("Cancel"), Tr("Ends after the picture at hand.")}}) == 0;
    if (wants_end || IsEscapePressed()) job.Cancel();
    return;
  }
  DrawResult(*editor, job, *result);
  if (DrawButtons(*editor, {{Tr("Close"), ""}}) < 0 && !IsEscapePressed()) return;
  render.job.reset();
  Close(editor);
}

}  // namespace hazumi::ui
