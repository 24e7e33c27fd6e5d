#pragma once

#include "engine/base/result.h"
#include "engine/figure/skin.h"

namespace hazumi {

// Whether all of a skin fits together, so that it can be drawn and written without looking again.
// Errors: kSemantics with the first place, such as `meshes[0].binds[1].bone`, that is an index out
// of range, a list of another length than the positions, a number that is not finite or a weight
// outside 0 to 1.
Result<Done> CheckSkin(const Skin& skin);

}  // namespace hazumi
