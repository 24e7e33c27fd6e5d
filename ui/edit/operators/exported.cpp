#include <filesystem>

#include "engine/bake/bake.h"
#include "engine/base/input_files.h"
#include "engine/base/version.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/foreign_files.h"

namespace hazumi::edit {

namespace {

// Null: none is wanted. What is made for it is put into `made`.
Result<const Skin*> SkinFor(const ExportSource& source, ExportSkin skin, Skin* made) {
  if (skin == ExportSkin::kNone) return nullptr;
  if (skin == ExportSkin::kCharacter) {
    if (source.character) return source.character.meshes().get();
    return Refusal("skin", "the figure has no meshes of its own; choose capsules or none");
  }
  if (!source.capsules) {
    return Refusal("skin",
                   "capsules are drawn by the editor and the command line alone; "
                   "choose none");
  }
  *made = source.capsules(*source.animation.figure);
  return made;
}

}  // namespace

const char* NameOf(ExportSkin skin) {
  switch (skin) {
    case ExportSkin::kCharacter:
      return "character";
    case ExportSkin::kCapsules:
      return "capsules";
    case ExportSkin::kNone:
      break;
  }
  return "none";
}

Result<ExportSource> ExportSourceOf(Session* session) {
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  const Project& project = session->project();
  return ExportSource{*session->animation(), *motion.value(), project.skin,
                      session->capsules(),   project.name,    project.source};
}

ExportSettings UsualSettings(const Session& session, MotionFormat format) {
  const Project& project = session.project();
  ExportSettings settings;
  settings.format = format;
  settings.first = project.frames.first;
  settings.last = project.frames.last;
  if (session.capsules()) settings.skin = ExportSkin::kCapsules;
  if (project.skin) settings.skin = ExportSkin::kCharacter;
  return settings;
}

// Bakes with the accelerations of every frame, which torques need and the session's motion lacks.
static Result<Motion> WithAccelerations(const ExportSource& source) {
  BakeOptions options;
  options.accelerations = true;
  Result<Motion> baked = Bake(source.animation, options);
  if (!baked.ok()) return baked.error();
  Motion motion = source.motion;
  motion.frames = std::move(baked.value().frames);
  return motion;
}

Result<OntoFile> OntoFileOf(const ExportSource& source, const ExportSettings& settings) {
  OntoOptions options;
  options.source = settings.onto;
  options.output = settings.path;
  if (source.imported_from) options.how = OptionsOf(*source.imported_from);
  return ExportOnto(source.animation, PartOf(source.motion, settings.first, settings.last),
                    options);
}

Result<std::string> BytesOf(const ExportSource& source, const ExportSettings& settings) {
  if (!settings.onto.empty()) {
    Result<OntoFile> file = OntoFileOf(source, settings);
    if (!file.ok()) return file.error();
    return std::move(file.value().bytes);
  }
  MotionExportOptions options;
  options.format = settings.format;
  if (!source.name.empty()) options.name = source.name;
  options.generator = std::string("Hazumi ") + kVersion;
  if (source.imported_from) options.above = source.imported_from->above;
  options.up = settings.up;
  options.metres_per_unit = settings.metres_per_unit;
  options.torques = settings.torques;
  Skin made;
  const bool has_skin =
      settings.format == MotionFormat::kGltf || settings.format == MotionFormat::kGlb;
  const Result<const Skin*> skin =
      SkinFor(source, has_skin ? settings.skin : ExportSkin::kNone, &made);
  if (!skin.ok()) return skin.error();
  options.skin = skin.value();
  if (!settings.torques) {
    return ExportMotion(source.animation, PartOf(source.motion, settings.first, settings.last),
                        options);
  }
  const Result<Motion> motion = WithAccelerations(source);
  if (!motion.ok()) return motion.error();
  return ExportMotion(source.animation, PartOf(motion.value(), settings.first, settings.last),
                      options);
}

std::optional<Error> CheckPlace(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    return Error{ErrorCode::kCannotWrite, path, "",
                 "there is no folder " + folder.string() + "; make it, or name another"};
  }
  if (std::filesystem::is_directory(path, ignored)) {
    return Error{ErrorCode::kCannotWrite, path, "", "is a folder; name a file in it"};
  }
  return WhyKept(path);
}

}  // namespace hazumi::edit
