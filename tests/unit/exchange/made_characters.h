#pragma once

// Characters made in memory, with nothing of a file about them.

#include "engine/bake/motion.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/import/joint_plan.h"
#include "tests/support/random.h"

namespace hazumi::test {

// A random tree of bones, of random rests and scales, under a bone that is no joint; a clip of
// rotations, smooth in time, and of translations of the root.
Character RandomCharacter(Random* random, int num_bones = 12, int num_frames = 20);

// A mesh of it: vertices near the bones, weighed at random, bound where the bones rest.
void AddSkin(Random* random, Character* character);

// A plan of the whole character, in metres as asked for.
struct Planned {
  Skeleton skeleton;
  WorldFrame world;
  FigurePlan plan;
  ImportReport report;
};
Planned PlanOf(const Character& character, const ImportOptions& options = {});

// An import that must succeed.
Imported ImportWell(const Character& character, const ImportOptions& options = {});

// A forearm, a hand, a bone of no length in it, three fingers of two bones; it turns for a second.
Character Hand();

// Compiles and bakes what must compile and bake.
Motion BakeWell(const Project& project);

}  // namespace hazumi::test
