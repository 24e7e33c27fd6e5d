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
// `is_computed`: by a region, see edit::IsSwung.
FieldState StateOfField(const ProjectCurve* curve, double frame, double shown, bool is_computed);

}  // namespace hazumi::ui
