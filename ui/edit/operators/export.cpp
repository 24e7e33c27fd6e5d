// Files for other programs.

#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "engine/exchange/onto/export_onto.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/foreign_files.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<MotionFormat> FormatOf(const std::string& path, bool is_onto) {
  if (const auto format = MotionFormatOf(path)) return *format;
  if (is_onto && CanBeOnto(path)) return MotionFormat::kGlb;
  if (LowerCase(path).ends_with(".mp4")) {
    return Refusal("path",
                   "videos are made by File > Export in the editor, or by "
                   "hazumi --export OUT.mp4 FILE");
  }
  return Refusal("path", "\"" + path + "\" ends in none of .bvh, .gltf, .glb, .csv, .json");
}

Result<Done> TakeFrames(const Parameters& p, const ProjectFrames& frames, ExportSettings* to) {
  to->first = p.integer("first", frames.first);
  to->last = p.integer("last", frames.last);
  const std::string all = "the animation has the frames " + std::to_string(frames.first) + " to " +
                          std::to_string(frames.last);
  if (to->first < frames.first || to->first > frames.last) return Refusal("first", all);
  if (to->last < frames.first || to->last > frames.last) return Refusal("last", all);
  if (to->first > to->last) return Refusal("first", "must not come after \"last\"");
  return Done();
}

// BVH says neither its axes nor its unit; the other formats say or define them.
Result<Done> TakeAxes(const Parameters& p, ExportSettings* settings) {
  for (const char* name : {"up", "unit"}) {
    if (p.has(name) && settings->format != MotionFormat::kBvh) {
      return Refusal(name, "only .bvh leaves this open; leave it out");
    }
  }
  const std::string up = p.text("up", "y");
  if (up != "y" && up != "z") return Refusal("up", "\"" + up + "\" is none of y, z");
  settings->up = up == "y" ? UpAxis::kY : UpAxis::kZ;
  settings->metres_per_unit = p.number("unit", settings->metres_per_unit);
  if (settings->metres_per_unit > 0.0) return Done();
  return Refusal("unit", "must be greater than 0");
}

Result<Done> TakeSkin(const Parameters& p, ExportSettings* settings) {
  if (!p.has("skin")) return Done();
  if (settings->format != MotionFormat::kGltf && settings->format != MotionFormat::kGlb) {
    return Refusal("skin", "only .gltf and .glb have meshes; leave it out");
  }
  const Result<ExportSkin> skin =
      ValueNamed(p.text("skin"), "skin",
                 {ExportSkin::kCharacter, ExportSkin::kCapsules, ExportSkin::kNone}, NameOf);
  if (!skin.ok()) return skin.error();
  settings->skin = skin.value();
  return Done();
}

// What is put into another file is as it is there.
Result<Done> TakeOnto(const Parameters& p, ExportSettings* settings) {
  settings->onto = p.text("onto");
  settings->path = p.text("path");
  if (settings->onto.empty()) return Done();
  for (const char* name : {"up", "unit", "skin", "torques"}) {
    if (p.has(name))
      return Refusal(name, "is as in the file that the motion is put into; leave it out");
  }
  if (CanBeOnto(settings->onto)) return Done();
  return Refusal("onto", "\"" + settings->onto + "\" ends in none of .glb, .gltf, .vrm, .bvh");
}

Result<Done> TakeTorques(const Parameters& p, ExportSettings* settings) {
  settings->torques = p.yes("torques");
  if (!settings->torques || HasTorques(settings->format)) return Done();
  return Refusal("torques", "only .json and .csv have a place for them; leave it out");
}

Result<ExportSettings> SettingsFrom(const Session& session, const Parameters& p) {
  const Result<MotionFormat> format = FormatOf(p.text("path"), p.has("onto"));
  if (!format.ok()) return format.error();
  ExportSettings settings = UsualSettings(session, format.value());
  for (const Result<Done>& taken :
       {TakeFrames(p, session.project().frames, &settings), TakeAxes(p, &settings),
        TakeSkin(p, &settings), TakeTorques(p, &settings), TakeOnto(p, &settings)}) {
    if (!taken.ok()) return taken.error();
  }
  return settings;
}

Result<Done> Export(Session* session, const Parameters& p) {
  const std::string path = p.text("path");
  const Result<ExportSettings> settings = SettingsFrom(*session, p);
  if (!settings.ok()) return settings.error();
  if (const auto error = CheckPlace(path)) return *error;
  const Result<ExportSource> source = ExportSourceOf(session);
  if (!source.ok()) return source.error();
  const Result<std::string> bytes = BytesOf(source.value(), settings.value());
  if (!bytes.ok()) return bytes.error();
  return WriteFileAtomically(path, bytes.value(), WriteMode::kDurable);
}

}  // namespace

std::vector<Operator> ExportOperators() {
  return {
      {"file.export",
       "Export motion",
       "Writes the motion for other programs: BVH, glTF, GLB, CSV or JSON.",
       {{"path", kText, true, "a .bvh, .gltf, .glb, .csv or .json file"},
        {"first", kInteger, false, "first frame; not given: that of the animation"},
        {"last", kInteger, false, "last frame, which is written too"},
        {"up", kText, false, "of .bvh: the axis that is up; not given: y", "y z"},
        {"unit", kNumber, false, "of .bvh: metres of its unit of length; not given: 0.01"},
        {"skin", kText, false,
         "of .gltf and .glb: the character's meshes, or else capsules, or none",
         "character capsules none"},
        {"onto", kText, false,
         "of .glb, .gltf, .vrm and .bvh: the file that the figure was imported from, to be "
         "written with its changed bones"},
        {"torques", kYesNo, false,
         "of .json and .csv: also the torque that every joint needs, and the force that nothing "
         "supplies"}},
       Export}};
}

}  // namespace hazumi::edit
