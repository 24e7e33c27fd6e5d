#pragma once

// Internal.

#include <optional>

#include "engine/project/checks/spans.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Whether a region may move a joint's body in some of these frames; no joint: the root's.
bool MayMove(const DynamicsRegion& region, std::optional<GroupIndex> joint, Span span,
             const Animation& animation);

}  // namespace hazumi
