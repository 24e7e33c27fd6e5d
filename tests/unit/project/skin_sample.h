#pragma once

// A skin of one triangle on the sample's figure.

#include "engine/figure/skin.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {

Skin SampleSkin();

// The sample with that skin, changed.
Json WithSkin(const Changes& changes);

}  // namespace hazumi::testing
