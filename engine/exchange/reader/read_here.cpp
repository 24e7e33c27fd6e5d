#include "engine/exchange/reader/read_here.h"

#include "engine/base/text.h"
#include "engine/exchange/assimp/assimp_read.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/bvh/bvh_motion.h"
#include "engine/exchange/character/character_check.h"
#include "engine/exchange/character/resampled.h"
#include "engine/exchange/gltf_reader/read_gltf.h"
#include "engine/exchange/reader/whole_file.h"
#include "engine/exchange/scene/scene_character.h"

namespace hazumi {
namespace {

Result<Character> ReadScene(CharacterFormat format, ReadUse use, std::string bytes,
                            const std::string& path, const ReadChoice& choice) {
  SceneFolder folder(path);
  const bool is_gltf = format == CharacterFormat::kGltf || format == CharacterFormat::kGlb;
  Result<Scene> scene = is_gltf ? ReadGltf(bytes, path, &folder)
                                : ReadByAssimp(format, std::move(bytes), path, &folder);
  if (!scene.ok()) return scene.error();
  return CharacterOf(use, std::move(scene).value(), choice, &folder, path);
}

Result<Character> ReadMotion(std::string_view bytes, const std::string& path,
                             const ReadChoice& choice) {
  if (!choice.character.empty()) {
    return Error{ErrorCode::kSemantics, path, "character",
                 "a BVH file has one alone; do not name any"};
  }
  Result<Character> read = ReadBvh(bytes, path, choice);
  if (!read.ok() || choice.rate <= 0.0) return read;
  for (Clip& clip : read.value().clips) {
    const double frames = clip.num_frames * clip.seconds_per_frame * choice.rate;
    if (frames > kMaxBvhFrames) {
      return Error{ErrorCode::kSemantics, path, "clip",
                   "would have " + FormatShort(frames) + " frames at " + FormatShort(choice.rate) +
                       " a second, of which " + std::to_string(kMaxBvhFrames) +
                       " are read; take fewer (--fps)"};
    }
    Resample(choice.rate, &clip);
  }
  return read;
}

}  // namespace

Result<Character> ReadHere(ReadUse use, const std::string& path, const ReadChoice& choice) {
  Result<std::string> bytes = WholeFile(path, kLongestFile);
  if (!bytes.ok()) return bytes.error();
  const Result<CharacterFormat> format = FormatOf(use, bytes.value(), path);
  if (!format.ok()) return format.error();
  const bool is_bvh = format.value() == CharacterFormat::kBvh;
  Result<Character> read =
      is_bvh ? ReadMotion(bytes.value(), path, choice)
             : ReadScene(format.value(), use, std::move(bytes).value(), path, choice);
  if (!read.ok()) return read;
  if (Result<Done> checked = CheckCharacter(read.value(), path); !checked.ok())
    return checked.error();
  return read;
}

}  // namespace hazumi
