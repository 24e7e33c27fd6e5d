#pragma once

#include <string>
#include <vector>

#include "engine/figure/figure.h"

namespace hazumi::ui {

// Joints in a row, from where the figure branches to its end or to the next branching.
struct Limb {
  std::string name;  // "Right arm"; English, a key of the catalogue where it has a word for it
  std::vector<GroupIndex> joints;  // from the root outwards
  bool is_end = false;             // nothing lies beyond it
};

// All limbs of a figure, every joint in one of them, in order of their first joints.
std::vector<Limb> LimbsOf(const Figure& figure);

// The hinges of a joint.
std::vector<JointIndex> HingesOf(const Figure& figure, GroupIndex joint);

}  // namespace hazumi::ui
