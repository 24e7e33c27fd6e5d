#pragma once

// Who holds an object when: those whom the object names, first to last.

#include <string>
#include <utility>
#include <vector>

#include "engine/project/project.h"

namespace hazumi::edit {

struct HolderSpan {
  int number;  // of the object's holders; -1: the joint that has it from the first frame on
  ItemId id;   // of that holder, or of the object
  std::string joint;
  int first, last;  // frames, half open
  bool is_let_go;   // at `last`; else that is the project's last frame
};

std::vector<HolderSpan> HoldersOf(const ProjectHeldObject& object, const ProjectFrames& frames);
// Of all objects, one after the other: the index of the object, and the span.
std::vector<std::pair<int, HolderSpan>> AllHolders(const Project& project);
// The one who has it at a frame; null: nobody.
const HolderSpan* HolderAt(int frame, const std::vector<HolderSpan>& holders);

}  // namespace hazumi::edit
