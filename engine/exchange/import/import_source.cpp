#include "engine/exchange/import/import_source.h"

namespace hazumi {

ProjectSource SourceOf(const Character& character, const Skeleton& skeleton, const Clip* clip,
                       const WorldFrame& world, const ImportOptions& options) {
  ProjectSource source;
  source.file = character.file;
  source.character = character.chosen;
  if (clip) source.clip = clip->name;
  source.above = character.above;
  std::vector<std::string> bones;  // above the root
  const Bone* bone = &character.bones[static_cast<size_t>(skeleton.bones[0].bone)];
  while (bone->parent >= 0) {
    bone = &character.bones[static_cast<size_t>(bone->parent)];
    bones.push_back(bone->name);
  }
  for (size_t i = bones.size(); i-- > 0;) {
    source.above += (source.above.empty() ? "" : "/") + bones[i];
  }
  source.fps = options.fps;
  source.z_up = world.up == UpAxis::kZ;
  source.metres_per_unit = world.metres;
  source.reduce_deg = options.reduce_deg;
  source.file_hinges = options.hinges == ImportHinges::kFile;
  source.file_facing = !options.faces_forward;
  return source;
}

ImportOptions OptionsOf(const ProjectSource& source) {
  ImportOptions options;
  options.character = source.character;
  options.clip = source.clip;
  options.fps = source.fps;
  options.up = source.z_up ? UpAxis::kZ : UpAxis::kY;
  options.metres_per_unit = source.metres_per_unit;
  options.reduce_deg = source.reduce_deg;
  options.hinges = source.file_hinges ? ImportHinges::kFile : ImportHinges::kBody;
  options.faces_forward = !source.file_facing;
  return options;
}

}  // namespace hazumi
