#pragma once

// A motion put into the file that its figure was imported from: README.md.

#include <functional>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/exchange/import/import_project.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct OntoOptions {
  std::string source;  // the file: glTF, GLB, VRM or BVH
  ImportOptions how;   // as it was imported
  std::string output;  // where it shall be written: in which folder, by which suffix
  std::function<bool()> is_cancelled = {};
};

struct OntoFile {
  std::string bytes;
  std::vector<std::string> bones;  // those that have changed
};

// Whether the name is that of a file that motion can be put into, by its suffix.
bool CanBeOnto(const std::string& path);

// Errors name the file: those of ReadCharacter; kSemantics: the figure is not of it; of
// EditedBonesOf, GltfOnto and BvhOnto; kCannotWrite: the output is the source itself, or needs
// files that lie beside it.
Result<OntoFile> ExportOnto(const Animation& animation, const Motion& motion,
                            const OntoOptions& options);

}  // namespace hazumi
