// The muscles of the region that is shown: what drives its joints, and which.

#include "ui/panels/properties/drives_draw.h"

#include <imgui.h>

#include <cctype>

#include "engine/timeline/curve_track.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/text/filled.h"

namespace hazumi::ui {

namespace {

struct Place {
  std::string region;
  int number;
  Json With(Json more) const {
    Json all = {{"region", region}, {"number", number}};
    all.update(more);
    return all;
  }
};

// As it is baked, in the current frame [N m].
double TorqueNow(const ProjectDrive& drive, const edit::Session& session) {
  const ProjectRate rate = session.project().fps;
  const Keys keys = ToKeys(drive.torque, 1.0);
  return CurveTrack(&keys, {rate.num, rate.den}, 0.0, {}).At(session.frame()).value;
}

// In the current frame; a change keys it there.
void DrawTorque(Editor* editor, const ProjectDrive& drive, const Place& place) {
  NumberField field{"torque", Tr("Torque here"), TorqueNow(drive, editor->session()), "%.2f N m",
                    0.1};
  DrawNumber(editor, field, [&](double value, const std::string& drag) {
    editor->Do("drive.key", place.With({{"torque", value}, {"drag", drag}}));
  });
  Tooltip(Tr("The torque in this frame; a change keys it here."));
  const double frame = editor->session().frame();
  for (const ProjectKey& key : drive.torque.keys) {
    if (key.frame != frame) continue;
    if (DrawButton(Tr("Remove torque key"), Tr("Takes the key of a torque on a frame away."))) {
      editor->Do("drive.remove_key", place.With({{"frame", frame}}));
    }
    return;
  }
}

// How strong a spring may be, where it says nothing of that yet. True if it was changed.
bool DrawLimits(const ProjectDrive& drive, const SetItem& set) {
  constexpr double kOfAnArm = 20.0;  // [N m]
  if (drive.max_torque_n_m || drive.strength) {
    if (!DrawButton(Tr("No limit"), Tr("true: it pulls as hard as it takes"))) return false;
    set({{"unlimited", true}}, "");
    return true;
  }
  if (DrawButton(Tr("By strength"),
                 Tr("share of what the joints' muscles can give, at their angle and rate"), 2)) {
    set({{"strength", 1.0}}, "");
    return true;
  }
  ImGui::SameLine();
  if (!DrawButton(Tr("By torque limit"),
                  Tr("it never pulls harder; of a ball joint about any axis"), 2)) {
    return false;
  }
  set({{"max_torque", kOfAnArm}}, "");
  return true;
}

// True if the list has changed.
bool DrawDrive(Editor* editor, const ProjectDrive& drive, const Place& place) {
  std::string names;
  for (const std::string& name : NamesOf(drive.joints)) {
    names += (names.empty() ? "" : ", ") + name;
  }
  ImGui::TextWrapped("%s", names.c_str());
  const SetItem set = SetBy(editor, "drive.set", place.With(Json::object()));
  DrawFieldRows(editor, drive, {"joints"}, set);
  if (drive.kind == DriveKind::kTorque) DrawTorque(editor, drive, place);
  if (drive.kind == DriveKind::kSpring && DrawLimits(drive, set)) return true;
  const edit::Session& session = editor->session();
  if (DrawButton(Tr("Selected joints"), Tr("It drives the selected joints."), 2)) {
    set({{"joints", WithSelected({}, session.figure(), session.selected_joints())}}, "");
    return true;
  }
  ImGui::SameLine();
  if (!DrawButton(Tr("Remove"), Tr("Takes a drive away: its joints are limp."), 2)) return false;
  editor->Do("drive.remove", place.With(Json::object()));
  return true;
}

}  // namespace

void DrawDrives(Editor* editor, const ProjectRegion& region) {
  if (!DrawHeading(Tr("Muscle"))) return;
  for (size_t i = 0; i < region.drives.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool has_changed =
        DrawDrive(editor, region.drives[i], {region.name, static_cast<int>(i)});
    ImGui::PopID();
    if (has_changed) return;
  }
  if (region.drives.empty()) ImGui::TextWrapped("%s", Tr("All joints are limp."));
  bool is_first = true;
  for (const auto& kind : EnumNames<DriveKind>::kNames) {
    if (!is_first) ImGui::SameLine();
    is_first = false;
    std::string word = kind.name;
    word[0] = static_cast<char>(std::toupper(word[0]));
    const std::string label = std::string("+ ") + Tr(word.c_str());
    if (!DrawButton(label.c_str(), Tr("Gives the selected joints, else all, muscle of this kind."),
                    3)) {
      continue;
    }
    editor->Do("drive.add", {{"region", region.name}, {"kind", kind.name}});
    return;
  }
}

}  // namespace hazumi::ui
