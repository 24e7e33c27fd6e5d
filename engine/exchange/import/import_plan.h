#pragma once

// Internal. What an import makes of a character before it is a project: which bone is which joint,
// and the angles that its keys say.

#include "engine/base/result.h"
#include "engine/exchange/import/joint_plan.h"

namespace hazumi {

struct ImportPlan {
  Character character;  // with one root, see one_root.h
  Skeleton skeleton;
  WorldFrame world;
  FigurePlan plan;
  std::optional<size_t> clip;  // of the character's; none: it is at rest
};

// Errors: those of ImportProject that a character's bones and clips have.
Result<ImportPlan> PlanImport(const Character& character, const ImportOptions& options);

}  // namespace hazumi
