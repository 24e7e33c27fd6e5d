#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/figure/figure.h"

namespace hazumi {

struct FromMotionOptions {
  std::string name = "motion";   // of the character and of its clip
  UpAxis up = UpAxis::kY;        // kZ: Hazumi's axes as they are
  double metres_per_unit = 1.0;  // of the lengths written
  const Skin* skin = nullptr;    // of the figure; none: no meshes
};

// A baked motion as a character with one clip that begins at time 0 and has the motion's frame
// rate. Bones are the root and the joints (groups of hinges), by their names, each parent before
// its children; at rest all angles are zero and the root stands at the origin.
//
// Hazumi's x forward, y left, z up become z, x and y of y-up axes: a permutation, which rounds no
// number. A joint whose hinges turn about different coordinate axes of an unturned frame has these
// as its rotation order and its hinges' angles as they are, with the sign of the axis; a bone
// without children ends where its capsules reach farthest. The root's rotation order is that of its
// curves: about the upward axis first, the forward one last.
//
// Error: the skin is bound to something that is no joint of the figure (kSemantics).
Result<Character> CharacterFromMotion(const Figure& figure, const Motion& motion,
                                      const FromMotionOptions& options);

}  // namespace hazumi
