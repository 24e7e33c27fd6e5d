#pragma once

#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::ui {

// Where a value at a frame comes from, as the colour of its field tells.
enum class FieldState {
  kPlain,         // nothing animates it
  kKeyed,         // a key on the frame
  kInterpolated,  // keys on other frames
  kChanged,       // a key on the frame, but something else moved it away, such as a hold
  kComputed       // by a dynamics region
};

// `curve`: null if there is none. `shown`: the value as it is at the frame, in the curve's units.
// `is_computed`: by a region, see IsComputed.
FieldState StateOfField(const ProjectCurve* curve, double frame, double shown, bool is_computed);

// Whether a region moves the hinge at a frame. On its first frame the hinge is still where its
// curve has it, unless another region ends there.
bool IsComputed(const Animation& animation, JointIndex hinge, double frame);
// Whether a pin, or gravity and contact, say where the root is.
bool IsPlaced(const Animation& animation, double frame);

}  // namespace hazumi::ui
