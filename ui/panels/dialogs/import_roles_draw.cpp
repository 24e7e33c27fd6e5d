// The bones of a character that is imported, as a figure to click on: what each of them is in a
// body.

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/dialogs/parts.h"
#include "ui/panels/text/role_text.h"

namespace hazumi::ui {

namespace {

constexpr float kHeight = 230.0f, kDot = 4.0f, kReach = 12.0f, kMargin = 14.0f;  // [px]
constexpr const char* kPopup = "##roles";

// A list of all roles. The one that was chosen.
std::optional<BodyPlace> DrawRoleList(const BodyPlace& now) {
  std::optional<BodyPlace> chosen;
  const std::string text = TextOf(now);
  for (const BodyPlace& place : AllPlaces()) {
    const bool is_now = TextOf(place) == text;
    if (ListLine(TextOf(place), is_now)) chosen = place;
    if (is_now && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
  }
  return chosen;
}

// Where bones are seen: from in front, or from the side if it is longer than it is wide.
class RestView {
 public:
  RestView(const std::vector<ImportedBone>& bones, ImVec2 from, ImVec2 size) {
    Vec3 low = bones[0].position, high = low;
    for (const ImportedBone& bone : bones) {
      low = low.cwiseMin(bone.position);
      high = high.cwiseMax(bone.position);
    }
    const Vec3 extent = high - low;
    across_ = extent.x() > 1.3 * extent.y() ? 0 : 1;
    const float width = std::max(static_cast<float>(extent[across_]), 1e-6f);
    const float height = std::max(static_cast<float>(extent.z()), 1e-6f);
    scale_ = std::min((size.x - 2.0f * kMargin) / width, (size.y - 2.0f * kMargin) / height);
    const Vec3 middle = 0.5 * (low + high);
    middle_ = {static_cast<float>(middle[across_]), static_cast<float>(middle.z())};
    centre_ = {from.x + 0.5f * size.x, from.y + 0.5f * size.y};
  }

  ImVec2 At(const Vec3& p) const {
    return {centre_.x + scale_ * (static_cast<float>(p[across_]) - middle_.x),
            centre_.y - scale_ * (static_cast<float>(p.z()) - middle_.y)};
  }

 private:
  int across_ = 1;
  float scale_ = 1.0f;
  ImVec2 middle_, centre_;
};

int NearestBone(const std::vector<ImportedBone>& bones, const RestView& view, ImVec2 mouse,
                float reach) {
  int nearest = -1;
  for (size_t i = 0; i < bones.size(); ++i) {
    const ImVec2 at = view.At(bones[i].position);
    const float off = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (off > reach) continue;
    reach = off;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void DrawBones(const std::vector<ImportedBone>& bones, const RestView& view, int marked,
               const Editor& editor) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const ImU32 known = ImGui::GetColorU32(ImGuiCol_CheckMark);
  for (const ImportedBone& bone : bones) {
    if (bone.parent < 0) continue;
    const ImportedBone& parent = bones[static_cast<size_t>(bone.parent)];
    list->AddLine(view.At(parent.position), view.At(bone.position), line, Px(editor, 1.5f));
  }
  for (size_t i = 0; i < bones.size(); ++i) {
    const ImVec2 at = view.At(bones[i].position);
    const bool is_known = bones[i].place.role != BodyRole::kNone;
    const bool is_marked = static_cast<int>(i) == marked;
    if (is_known) list->AddCircleFilled(at, Px(editor, kDot), known);
    if (!is_known) list->AddCircle(at, Px(editor, kDot), line);
    if (is_marked) {
      list->AddCircle(at, Px(editor, 2.0f * kDot), ImGui::GetColorU32(ImGuiCol_Text), 0,
                      Px(editor, 2.0f));
    }
  }
}

// The figure. The bone that was clicked.
std::optional<int> DrawFigure(const Editor& editor, const std::vector<ImportedBone>& bones,
                              int selected) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size = {ImGui::GetContentRegionAvail().x, Px(editor, kHeight)};
  ImGui::InvisibleButton("##figure", size);
  ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + size.x, from.y + size.y},
                                            ImGui::GetColorU32(ImGuiCol_WindowBg));
  const RestView view(bones, from, size);
  int under = -1;
  if (ImGui::IsItemHovered())
    under = NearestBone(bones, view, ImGui::GetMousePos(), Px(editor, kReach));
  DrawBones(bones, view, under >= 0 ? under : selected, editor);
  if (under < 0) return std::nullopt;
  const ImportedBone& bone = bones[static_cast<size_t>(under)];
  ImGui::SetTooltip("%s: %s", bone.name.c_str(), TextOf(bone.place).c_str());
  return ImGui::IsItemClicked() ? std::optional(under) : std::nullopt;
}

void Choose(const ImportedBone& bone, BodyPlace place, ImportState* state) {
  state->options.roles[bone.name] = place;
}

// By the keyboard: a bone, then what it is.
bool DrawLists(const Editor& editor, const std::vector<ImportedBone>& bones, ImportState* state) {
  DrawFieldLabel(Tr("Bone"), editor);
  ImGui::SetNextItemWidth(-1.0f);
  const std::string shown =
      state->bone < 0 ? Tr("choose one") : bones[static_cast<size_t>(state->bone)].name;
  if (ImGui::BeginCombo("##bone", shown.c_str())) {
    for (size_t i = 0; i < bones.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      const std::string line = bones[i].name + "   " + TextOf(bones[i].place);
      if (ListLine(line, static_cast<int>(i) == state->bone)) state->bone = static_cast<int>(i);
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  const bool has_bone = state->bone >= 0;
  const ImportedBone bone = has_bone ? bones[static_cast<size_t>(state->bone)] : ImportedBone();
  DrawFieldLabel(Tr("It is"), editor);
  ImGui::SetNextItemWidth(-1.0f);
  std::optional<BodyPlace> chosen;
  ImGui::BeginDisabled(!has_bone);
  const bool is_open = ImGui::BeginCombo("##role", has_bone ? TextOf(bone.place).c_str() : "");
  ImGui::EndDisabled();
  if (is_open) {
    chosen = DrawRoleList(bone.place);
    ImGui::EndCombo();
  }
  if (chosen) Choose(bone, *chosen, state);
  return chosen.has_value();
}

}  // namespace

bool DrawRoles(const Editor& editor, ImportState* state) {
  if (!state->imported || !state->imported->ok()) {
    // A role that cannot be is taken back, so that the figure is there again.
    const bool was_refused = state->imported && !state->options.roles.empty();
    if (!was_refused || !ImGui::Button(Tr("Roles as they are told"))) return false;
    state->options.roles.clear();
    return true;
  }
  const std::vector<ImportedBone>& bones = state->imported->value().report.bones;
  state->bone = std::min(state->bone, static_cast<int>(bones.size()) - 1);
  if (bones.empty() || !ImGui::CollapsingHeader(Tr("What bones are"))) return false;
  ImGui::TextWrapped("%s", Tr("Click a bone to say what it is. Filled: it has a role in a body."));
  const std::optional<int> clicked = DrawFigure(editor, bones, state->bone);
  if (clicked) {
    state->bone = *clicked;
    ImGui::OpenPopup(kPopup);
  }
  bool is_changed = false;
  ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {FLT_MAX, Px(editor, kHeight)});
  if (ImGui::BeginPopup(kPopup)) {
    const ImportedBone& bone = bones[static_cast<size_t>(state->bone)];
    ImGui::TextDisabled("%s", bone.name.c_str());
    if (const std::optional<BodyPlace> chosen = DrawRoleList(bone.place)) {
      Choose(bone, *chosen, state);
      is_changed = true;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  return DrawLists(editor, bones, state) || is_changed;
}

}  // namespace hazumi::ui
