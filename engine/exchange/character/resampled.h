#pragma once

#include "engine/exchange/character/character.h"

namespace hazumi {

// Resamples a clip at another frame rate [1/s]; the motion stays the same. Translations and scales
// are interpolated linearly, rotations by slerp. Times after the last frame repeat the last frame.
// Angles in the file's rotation order are dropped.
void Resample(double rate, Clip* clip);

}  // namespace hazumi
