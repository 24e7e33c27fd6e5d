// The muscles of the region that is shown: what drives its joints, and which.

#include <imgui.h>

#include <cctype>

#include "engine/base/filled.h"
#include "engine/timeline/curve_track.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/properties/sections.h"

namespace hazumi::ui {

namespace {

struct DrivePlace {
  std::string region;
  int number;
  Json With(Json more) const {
    Json all = {{"region", region}, {"number", number}};
    all.update(more);
    return all;
  }
};

// What of a drive has keys of its own.
struct KeyedRow {
  const char* parameter;
  const char* label;
  const char* format;
  double step;
};

// As it is baked, in the current frame.
double ValueNow(const ProjectCurve& curve, const edit::Session& session) {
  const ProjectRate rate = session.project().fps;
  const Keys keys = ToKeys(curve, 1.0);
  return CurveTrack(&keys, {rate.num, rate.den}, 0.0, {}).At(session.frame()).value;
}

// In the current frame; a change keys it there.
void DrawKeyed(Editor* editor, const KeyedRow& row, const ProjectCurve& curve,
               const DrivePlace& place) {
  NumberField field{row.parameter, Tr(row.label), ValueNow(curve, editor->session()), row.format,
                    row.step};
  DrawNumber(editor, field, [&](double value, const std::string& drag) {
    editor->Do("drive.key", place.With({{row.parameter, value}, {"drag", drag}}));
  });
  Tooltip(Tr("What it is in this frame; a change keys it here."));
  const double frame = editor->session().frame();
  for (const ProjectKey& key : curve.keys) {
    if (key.frame != frame) continue;
    ImGui::PushID(row.parameter);
    if (DrawButton(Tr("Remove this key"), Tr("Takes keys of a drive on a frame away."))) {
      editor->Do("drive.remove_key", place.With({{"frame", frame}, {"of", row.parameter}}));
    }
    ImGui::PopID();
    return;
  }
}

// Keys of them replace the one number.
void DrawOverTime(Editor* editor, const ProjectDrive& drive, const DrivePlace& place) {
  constexpr KeyedRow kFrequency = {"frequency", "Frequency here", "%.2f Hz", 0.02};
  constexpr KeyedRow kStrength = {"strength", "Strength here", "%.2f", 0.01};
  if (!drive.frequency_over_time.keys.empty()) {
    DrawKeyed(editor, kFrequency, drive.frequency_over_time, place);
  } else if (DrawButton(Tr("Key frequency"), Tr("Makes it change over time, from this frame on."),
                        2)) {
    editor->Do("drive.key", place.With({{"frequency", drive.frequency_hz}}));
  }
  if (!drive.strength_over_time.keys.empty()) {
    DrawKeyed(editor, kStrength, drive.strength_over_time, place);
  } else if (drive.strength) {
    if (drive.frequency_over_time.keys.empty()) ImGui::SameLine();
    if (DrawButton(Tr("Key strength"), Tr("Makes it change over time, from this frame on."), 2)) {
      editor->Do("drive.key", place.With({{"strength", *drive.strength}}));
    }
  }
}

// Those that are drawn in a way of their own.
std::vector<std::string> KeyedFields(const ProjectDrive& drive) {
  std::vector<std::string> names = {"joints"};
  if (!drive.frequency_over_time.keys.empty()) names.emplace_back("frequency");
  if (!drive.strength_over_time.keys.empty()) names.emplace_back("strength");
  return names;
}

// How strong a spring may be, where it says nothing of that yet. True if it was changed.
bool DrawLimits(const ProjectDrive& drive, const SetItem& set) {
  constexpr double kOfAnArm = 20.0;  // [N m]
  if (drive.max_torque_n_m || drive.strength || !drive.strength_over_time.keys.empty()) {
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
bool DrawDrive(Editor* editor, const ProjectDrive& drive, const DrivePlace& place) {
  std::string names;
  for (const std::string& name : NamesOf(drive.joints)) {
    names += (names.empty() ? "" : ", ") + name;
  }
  ImGui::TextWrapped("%s", names.c_str());
  const SetItem set = SetBy(editor, "drive.set", place.With(Json::object()));
  DrawFieldRows(editor, drive, KeyedFields(drive), set);
  if (drive.kind == DriveKind::kTorque) {
    DrawKeyed(editor, {"torque", "Torque here", "%.2f N m", 0.1}, drive.torque, place);
  }
  if (drive.kind == DriveKind::kSpring) DrawOverTime(editor, drive, place);
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
