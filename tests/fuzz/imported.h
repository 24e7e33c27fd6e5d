#pragma once

#include "engine/base/assert.h"
#include "engine/exchange/import/import_project.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"

namespace hazumi::fuzz {

// A small character becomes a project or is refused; a project is one that can be read and
// compiled.
inline void ImportIfSmall(const Character& character) {
  constexpr size_t kMostBones = 24;
  constexpr int kMostFrames = 24;
  if (character.bones.size() > kMostBones) return;
  for (const Clip& clip : character.clips) {
    if (clip.num_frames > kMostFrames) return;
  }
  const Result<Imported> imported = ImportProject(character, {});
  if (!imported.ok()) return;
  const Result<Project> again = ParseProject(WriteProject(imported.value().project), "again.kfa");
  HAZUMI_DEMAND(again.ok());
  HAZUMI_DEMAND(CompileAnimation(again.value()).ok());
}

}  // namespace hazumi::fuzz
