// The poses of the library among the properties: pictures to click on and to pull.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/commands/actions.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/poses/actions.h"
#include "ui/panels/poses/thumbnails.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/sections.h"

namespace hazumi::ui {

namespace {

constexpr double kTile = 84.0;  // least edge of a picture, at scale 1 [px]
constexpr float kDragPx = 4.0f;

Json ParametersOf(const SavedPose& pose, const Editor& editor) {
  Json parameters = {{"name", pose.name}};
  if (editor.poses.is_flipped) parameters["flipped"] = true;
  return parameters;
}

// A click applies it, pulling blends, the right button offers more of an own one.
void ActOnTile(Editor* editor, const SavedPose& pose, bool is_own) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_pulled = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > kDragPx * kDragPx;
  if (ImGui::IsItemActive() && is_pulled) {
    const HeldFrom held = {FromIm(io.MouseClickedPos[ImGuiMouseButton_Left])};
    ImGui::ClearActiveID();  // one press is one pull, also when the tool is cancelled
    TakeShareTool(editor, "pose.apply", ParametersOf(pose, *editor), held).ok();
  } else if (ImGui::IsItemDeactivated() && ImGui::IsItemHovered() && !is_pulled) {
    editor->Do("pose.apply", ParametersOf(pose, *editor));
  }
  if (!is_own || !ImGui::BeginPopupContextItem("##more")) return;
  for (const char* id : {"pose.rename", "pose.remove"}) {
    if (ImGui::MenuItem(LabelOf(id))) RunOrAsk(editor, id, {{"name", pose.name}}).ok();
  }
  ImGui::EndPopup();
}

// As much of a name as there is room for.
std::string Shortened(const std::string& name, float width) {
  if (ImGui::CalcTextSize(name.c_str()).x <= width) return name;
  std::string text = name;
  while (!text.empty() && ImGui::CalcTextSize((text + "...").c_str()).x > width) {
    do {
      text.pop_back();
    } while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80);
  }
  return text + "...";
}

void DrawTile(Editor* editor, const SavedPose& pose, bool is_own, float edge) {
  const std::string name = is_own ? pose.name : Tr(pose.name.c_str());
  if (is_own) editor->NeedGlyphs(name);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  ImGui::PushID(pose.name.c_str());
  ImGui::InvisibleButton("##pose", {edge, edge + line});
  const bool is_hovered = ImGui::IsItemHovered();
  const std::string shown = Shortened(name, edge);
  if (shown != name) Tooltip(name);
  if (ImGui::IsItemVisible()) {
    const auto texture = editor->poses.thumbnails->TextureOf(pose);
    const ImVec2 end(at.x + edge, at.y + edge);
    Canvas()->AddRectFilled(at, end, ToIm(editor->theme().header), 3.0f);
    if (texture != 0) {
      const float left = editor->poses.is_flipped ? 1.0f : 0.0f;
      Canvas()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), at,
                         end, {left, 0.0f}, {1.0f - left, 1.0f});
    }
    if (is_hovered) Canvas()->AddRect(at, end, ToIm(editor->theme().accent), 3.0f, 0, 2.0f);
    Canvas()->AddText({at.x, end.y}, ToIm(editor->theme().text), shown.c_str());
  }
  ActOnTile(editor, pose, is_own);
  ImGui::PopID();
}

void DrawTiles(Editor* editor, const std::vector<SavedPose> poses, bool is_own) {
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = ImGui::GetContentRegionAvail().x;
  const double least = kTile * editor->settings.scale;
  const int columns = std::max(1, static_cast<int>((width + gap) / (least + gap)));
  const float edge = std::floor((width + gap) / static_cast<float>(columns) - gap);
  for (size_t i = 0; i < poses.size(); ++i) {
    if (i % static_cast<size_t>(columns) != 0) ImGui::SameLine();
    DrawTile(editor, poses[i], is_own, std::max(edge, 1.0f));
  }
}

}  // namespace

void DrawPosesSection(Editor* editor) {
  PosesState& state = editor->poses;
  const std::optional<Error> error = state.library.Refresh();
  const Animation* animation = editor->session().animation();
  if (!animation) return DrawNote(Tr("the project cannot be animated as it is"));
  if (!state.thumbnails) state.thumbnails = std::make_shared<Thumbnails>(editor->pictures);
  const auto edge_px = static_cast<int>(std::lround(2.0 * kTile * editor->settings.scale));
  state.thumbnails->Begin(animation->figure, edge_px);
  if (DrawButton((std::string(LabelOf("pose.save")) + "...").c_str(), HelpOf("pose.save"))) {
    RunOrAsk(editor, "pose.save", Json::object()).ok();
  }
  DrawCheck(editor, "flipped", Tr("Left for right"), state.is_flipped,
            [&](bool is_on) { state.is_flipped = is_on; });
  DrawNote(Tr("Click: apply. Pull to the right: a part of the way."));
  if (DrawHeading(Tr("Own poses"))) {
    if (error) DrawNote(TextOf(*error, "pose.apply"));
    if (!error && state.library.own().empty()) {
      DrawNote(Tr("None yet. What is kept here is there in every project."));
    }
    DrawTiles(editor, state.library.own(), true);
  }
  if (DrawHeading(Tr("Poses of the human"))) DrawTiles(editor, ShippedPoses(), false);
  state.thumbnails->End();
}

}  // namespace hazumi::ui
