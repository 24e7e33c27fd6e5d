#pragma once

// A baked motion as a file of any format that others read, by the file's name.

#include <optional>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/motion_text.h"
#include "engine/timeline/animation.h"

namespace hazumi {

enum class MotionFormat { kBvh, kGltf, kGlb, kCsv, kJson };

// By the suffix, in any case: .bvh .gltf .glb .csv .json.
std::optional<MotionFormat> MotionFormatOf(const std::string& path);

inline bool HasTorques(MotionFormat format) {
  return format == MotionFormat::kCsv || format == MotionFormat::kJson;
}

struct MotionExportOptions {
  MotionFormat format = MotionFormat::kGlb;
  std::string name = "motion";
  std::string generator = "Hazumi";  // of glTF
  // Of BVH, which states neither. Blender reads Y up, and one unit as a metre unless its import
  // scale is set to 0.01; MotionBuilder, Maya and Unreal read Y up and centimetres, as nearly all
  // BVH libraries are. glTF is y up and metres by definition.
  UpAxis up = UpAxis::kY;
  double metres_per_unit = 0.01;
  const Skin* skin = nullptr;             // of glTF; none: the skeleton alone
  std::string above = {};                 // of glTF: nodes on which the skeleton hangs
  bool timings = false;                   // of JSON
  bool torques = false;                   // of JSON and CSV
  MotionJsonOptions::Maker made_by = {};  // of JSON
  bool effort = false;                    // of JSON and CSV
};

// What a file of this format cannot hold of a motion, each by name.
std::vector<Warning> LeftOutOf(const Animation& animation, MotionFormat format);

// The bytes of the file; in glTF held objects are nodes with meshes. Errors: those of
// CharacterFromMotion and GltfFile.
Result<std::string> ExportMotion(const Animation& animation, const Motion& motion,
                                 const MotionExportOptions& options);

// The part of a motion from frame `first` to `last`, both inclusive, with the events in it. Rates
// and regions stay those of the whole.
Motion PartOf(const Motion& motion, int first, int last);

}  // namespace hazumi
