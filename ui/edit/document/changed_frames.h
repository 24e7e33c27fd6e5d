#pragma once

#include <vector>

#include "engine/project/project.h"

namespace hazumi::edit {

// Both inclusive.
struct FrameSpan {
  double first, last;
  bool operator==(const FrameSpan&) const = default;
};

// The frames of what two states of a project differ in, in no order: of keys and markers their
// frames, of what has a beginning and an end the part that was added or taken away, or all of it if
// something else about it differs. What has no frame, such as a name, gives none.
std::vector<FrameSpan> ChangedFrames(const Project& before, const Project& after);

}  // namespace hazumi::edit
