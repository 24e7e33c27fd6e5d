// Names of a form's list as ticks, a line a limb, with the whole limb at its beginning.

#include <imgui_internal.h>

#include <algorithm>

#include "ui/edit/operators/edits.h"
#include "ui/panels/forms/parts.h"
#include "ui/panels/properties/layout.h"

namespace hazumi::ui {

namespace {

using Names = std::vector<std::string>;

bool Has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void Put(const std::string& name, bool is_in, Names* names) {
  std::erase(*names, name);
  if (is_in) names->push_back(name);
}

std::string Joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// On the line if it has room there.
bool DrawTick(const std::string& label, bool* is_on, float left) {
  const float width = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                      ImGui::CalcTextSize(label.c_str()).x;
  ImGui::SameLine();
  if (ImGui::GetCursorPosX() + width > ImGui::GetWindowContentRegionMax().x) {
    ImGui::NewLine();
    ImGui::SetCursorPosX(left);
  }
  return ImGui::Checkbox(label.c_str(), is_on);
}

// The whole of a limb: on, off, or some of it.
void DrawLimb(const std::vector<FormOption>& limb, const Editor& editor, Names* names) {
  const auto num_on = std::count_if(limb.begin(), limb.end(), [&](const FormOption& option) {
    return Has(*names, option.value);
  });
  bool is_all = num_on == static_cast<long>(limb.size());
  const TabStops stops(false);
  ImGui::PushID(limb.front().group.c_str());
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, num_on > 0 && !is_all);
  if (ImGui::Checkbox(Tr(limb.front().group.c_str()), &is_all)) {
    for (const FormOption& option : limb) Put(option.value, is_all, names);
  }
  ImGui::PopItemFlag();
  const float column = Px(editor, 110), left = column + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SameLine(column);
  ImGui::Dummy({0.0f, ImGui::GetFrameHeight()});
  for (const FormOption& option : limb) {
    bool is_on = Has(*names, option.value);
    if (DrawTick(option.label, &is_on, left)) Put(option.value, is_on, names);
  }
  ImGui::PopID();
}

// What no limb has, such as "r_shoulder+", the hinge of a joint, or what was misspelt.
std::vector<FormOption> Others(const std::vector<FormOption>& options, const Names& names) {
  std::vector<FormOption> others;
  for (const std::string& name : names) {
    const bool is_there = std::any_of(options.begin(), options.end(),
                                      [&](const FormOption& o) { return o.value == name; });
    if (!is_there) others.push_back({name, name, "Others"});
  }
  return others;
}

std::vector<std::vector<FormOption>> ByGroup(const std::vector<FormOption>& options) {
  std::vector<std::vector<FormOption>> groups;
  for (const FormOption& option : options) {
    if (groups.empty() || groups.back().front().group != option.group) groups.emplace_back();
    groups.back().push_back(option);
  }
  return groups;
}

// Of curves those of the selected hinges, of joints the selected ones.
Names SelectedOf(const FormField& field, const std::vector<FormOption>& options,
                 const edit::Session& session) {
  const std::set<std::string>& selected = session.selected_joints();
  if (field.info.offer.thing == Thing::kJointOrRoot) return edit::SelectedNames(session);
  if (field.info.offer.thing != Thing::kCurve) {
    return WithSelected({}, session.figure(), selected);
  }
  const bool has_root = session.is_root_selected();
  Names names;
  for (const FormOption& option : options) {
    const bool is_of_root = option.group == "Root" && has_root;
    if (is_of_root || selected.contains(option.value)) names.push_back(option.value);
  }
  return names;
}

// How many there are, and quick ways to change them.
void DrawSummary(const Editor& editor, const FormField& field,
                 const std::vector<FormOption>& options, Names* names) {
  ImGui::AlignTextToFramePadding();
  if (names->empty() && !field.is_main) {
    ImGui::TextUnformatted(Tr("(not given)"));
  } else {
    ImGui::Text(Tr("%d chosen"), static_cast<int>(names->size()));
  }
  ImGui::SameLine();
  if (ImGui::Button(Tr("The selected ones"))) {
    *names = SelectedOf(field, options, editor.session());
  }
  ImGui::SameLine();
  if (ImGui::Button(Tr("None"))) names->clear();
}

}  // namespace

void DrawTicks(const std::vector<FormOption>& options, FormField* field, Editor* editor) {
  Names names = Parts(field->text);
  const float line = ImGui::GetFrameHeightWithSpacing();
  const std::vector<FormOption> others = Others(options, names);
  const std::vector<std::vector<FormOption>> groups = ByGroup(options);
  const float lines = std::min(8.0f, static_cast<float>(groups.size() + !others.empty()));
  ImGui::BeginGroup();
  DrawSummary(*editor, *field, options, &names);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ToIm4(editor->theme().row_odd));
  ImGui::BeginChild("##ticks", {0.0f, lines * line + ImGui::GetStyle().WindowPadding.y * 2.0f},
                    true, ImGuiWindowFlags_NavFlattened);
  for (const std::vector<FormOption>& group : groups) DrawLimb(group, *editor, &names);
  if (!others.empty()) DrawLimb(others, *editor, &names);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
  field->text = Joined(names);
}

}  // namespace hazumi::ui
