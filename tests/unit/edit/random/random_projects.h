#pragma once

#include <string>

#include "tests/unit/edit/random/random_operators.h"

namespace hazumi::test {

// Files for random operators, written into a folder: both shipped examples, one with a skin; small
// BVH clips of skeletons at random; the projects that they become; and of each project one with
// regions of both methods, placements, holds and markers that random operators put there.
RandomFiles WriteRandomFiles(const std::string& folder, uint64_t seed);
// As they were written, whatever was saved over them since; what was written beside them is gone.
void RestoreRandomFiles(const RandomFiles& files);

// The text of a small BVH clip: of a figure with legs and arms, or of any tree of joints.
std::string RandomBvh(bool is_person, Random* random);

}  // namespace hazumi::test
