#include "engine/project/pose_file.h"

#include "engine/project/checks/field_checks.h"
#include "engine/project/json/described_file.h"
#include "engine/project/json/field_writer.h"
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
  ar.Optional({.name = "standing_height_m", .unit = "m"}, root.standing_height_m);
}

template <typename Ar>
void Describe(Ar& ar, Ref<Ar, SavedPose> pose) {
  ar.Required(kNameField, pose.name);
  ar.Optional({"root"}, pose.root);
  ar.Required({.name = "joints", .unit = "°"}, pose.joints);
  ar.Optional({.name = "human", .unit = "°"}, pose.human);
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
  KeepInput(path, InputKind::kPoses);
  return ParsePoses(text.value(), path);
}

Result<PoseFile> ParsePoses(std::string_view text, const std::string& file_name) {
  return ParseDescribedFile<PoseFile>(text, file_name, kPoseFormat, Check::kNotPoses,
                                      [](const PoseFile& file, FirstError* errors) {
                                        CheckNamesUnique(file.poses, Site{"poses", errors});
                                      });
}

std::string WritePoses(const PoseFile& file) { return FormatJson(ToJson(file)); }

}  // namespace hazumi
