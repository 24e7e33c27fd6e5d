#include "engine/project/pose_file.h"

#include "engine/project/checks/field_checker.h"
#include "engine/project/checks/unique_names.h"
#include "engine/project/figure_fields.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/read_value.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

constexpr const char* kPoseFormat = "hazumi-poses";

}  // namespace

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SavedRoot> root) {
  ar.Required({.name = "height_m", .unit = "m"}, root.height_m);
  ar.Optional({.name = "angle_y_deg", .unit = "°"}, root.angle_y_deg);
  ar.Optional({.name = "angle_x_deg", .unit = "°"}, root.angle_x_deg);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SavedPose> pose) {
  ar.Required(kNameField, pose.name);
  ar.Optional({"root"}, pose.root);
  ar.Required({.name = "joints", .unit = "°"}, pose.joints);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, PoseFile> file) {
  ar.Literal("format", kPoseFormat);
  ar.Literal("version", 1);
  ar.Required({"poses"}, file.poses);
}

Result<PoseFile> LoadPoses(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  return ParsePoses(text.value(), path);
}

Result<PoseFile> ParsePoses(std::string_view text, const std::string& file_name) {
  FirstError errors;
  const std::optional<Json> json = ParseJson(text, &errors);
  if (!json) return errors.In(file_name);
  PoseFile file;
  const Site site{"", &errors, &file.read.warnings};
  if (ExpectFormat(*json, kPoseFormat, 1, Check::kNotPoses, site)) ReadValue(*json, site, file);
  if (errors.ok()) {
    FieldChecker fields(&errors);
    Describe(fields, file);
    CheckNamesUnique(file.poses, site.Field("poses"));
  }
  if (!errors.ok()) return errors.In(file_name);
  return file;
}

std::string WritePoses(const PoseFile& file) { return FormatJson(ToJson(file)); }

}  // namespace hazumi
