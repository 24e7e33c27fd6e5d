#pragma once

// Internal: what moves the figure at a frame, its keys apart.

#include "engine/timeline/animation.h"

namespace hazumi::edit {

// Whether a region, a placement or a hold has taken over: on its first frame all is still where the
// keys have it, unless another one ends there.
template <typename Span>
bool HasTakenOver(const Span& span, double frame) {
  return frame > span.first_frame && frame <= span.last_frame;
}

// Whether a region moves the hinge.
bool IsSwung(const Animation& animation, JointIndex hinge, double frame);
// Whether a pin, or gravity and contact, say where the root is.
bool IsPlaced(const Animation& animation, double frame);

}  // namespace hazumi::edit
