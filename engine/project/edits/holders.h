#pragma once

// The holders of an object: joints that have it for some frames each, in order of time.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/project/project.h"

namespace hazumi {

struct HolderSpan {
  int number;  // of the object's holders; -1: the joint that has it from the first frame on
  ItemId id;   // of that holder, or of the object
  std::string joint;
  int first, last;  // frames, half open
  bool is_let_go;   // at `last`; else that is the project's last frame
};

std::vector<HolderSpan> HoldersOf(const ProjectHeldObject& object, const ProjectFrames& frames);
// Returns the holders of all objects, one object after the other: its index, and the span.
std::vector<std::pair<int, HolderSpan>> AllHolders(const Project& project);
// Returns the holder at a frame, or null.
const HolderSpan* HolderAt(int frame, const std::vector<HolderSpan>& holders);

// Frame on which a holder (HolderSpan::number) lets go; nothing: never.
std::optional<int>& EndOf(int number, ProjectHeldObject* object);
// Keys the object's centre, which counts while nobody holds it [m].
void PutPosition(const Vec3& at, double frame, ProjectHeldObject* object);

}  // namespace hazumi
