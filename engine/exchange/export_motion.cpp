#include "engine/exchange/export_motion.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "engine/base/text.h"
#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/character/from_motion.h"
#include "engine/exchange/gltf/gltf_of_motion.h"
#include "engine/exchange/gltf/gltf_write.h"
#include "engine/exchange/motion_text.h"

namespace hazumi {

namespace {

Result<std::string> ExportBvh(const Animation& animation, const Motion& motion,
                              const MotionExportOptions& options) {
  const FromMotionOptions from{options.name, options.up, options.metres_per_unit, nullptr};
  const Result<Character> character = CharacterFromMotion(*animation.figure, motion, from);
  if (!character.ok()) return character.error();
  return BvhText(character.value(), character.value().clips.front());
}

Result<std::string> ExportGltf(const Animation& animation, const Motion& motion,
                               const MotionExportOptions& options) {
  const FromMotionOptions from{options.name, UpAxis::kY, 1.0, options.skin};
  Result<Character> character = CharacterFromMotion(*animation.figure, motion, from);
  if (!character.ok()) return character.error();
  const auto container =
      options.format == MotionFormat::kGlb ? GltfContainer::kBinary : GltfContainer::kText;
  std::vector<GltfProp> held =
      HeldProps(animation, motion, FileAxes(UpAxis::kY, 1.0), &character.value());
  return GltfFile(character.value(), {container, options.generator, MotionExtras(animation, motion),
                                      std::move(held), options.above});
}

}  // namespace

std::optional<MotionFormat> MotionFormatOf(const std::string& path) {
  const std::string suffix = LowerCase(std::filesystem::path(path).extension().string());
  if (suffix == ".bvh") return MotionFormat::kBvh;
  if (suffix == ".gltf") return MotionFormat::kGltf;
  if (suffix == ".glb") return MotionFormat::kGlb;
  if (suffix == ".csv") return MotionFormat::kCsv;
  if (suffix == ".json") return MotionFormat::kJson;
  return std::nullopt;
}

std::vector<Warning> LeftOutOf(const Animation& animation, MotionFormat format) {
  std::vector<Warning> warnings;
  if (format != MotionFormat::kBvh && format != MotionFormat::kCsv) return warnings;
  const char* holds = format == MotionFormat::kBvh ? "BVH holds a skeleton alone"
                                                   : "CSV holds joints and the root alone";
  for (size_t i = 0; i < animation.held_objects.size(); ++i) {
    warnings.push_back({"held_objects[" + std::to_string(i) + "]",
                        "\"" + animation.held_objects[i].name + "\" is not written: " + holds +
                            "; glTF holds it too"});
  }
  return warnings;
}

Result<std::string> ExportMotion(const Animation& animation, const Motion& motion,
                                 const MotionExportOptions& options) {
  switch (options.format) {
    case MotionFormat::kBvh:
      return ExportBvh(animation, motion, options);
    case MotionFormat::kGltf:
    case MotionFormat::kGlb:
      return ExportGltf(animation, motion, options);
    case MotionFormat::kCsv:
      return MotionToCsv(animation, motion, options.torques, options.effort);
    case MotionFormat::kJson:
      return MotionToJson(animation, motion,
                          {options.timings, options.torques, options.made_by, options.effort});
  }
  return Error{ErrorCode::kFailed, "", "", "unknown format"};
}

Motion PartOf(const Motion& motion, int first, int last) {
  Motion part{motion.rate, {}, {}, motion.regions, motion.warnings, motion.placement_jumps,
              motion.seams};
  std::copy_if(motion.frames.begin(), motion.frames.end(), std::back_inserter(part.frames),
               [&](const MotionFrame& f) { return f.frame >= first && f.frame <= last; });
  const double start = motion.rate.SecondsAt(first), end = motion.rate.SecondsAt(last);
  std::copy_if(motion.events.begin(), motion.events.end(), std::back_inserter(part.events),
               [&](const MotionEvent& e) { return e.time >= start && e.time <= end; });
  return part;
}

}  // namespace hazumi
