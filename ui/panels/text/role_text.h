#pragma once

#include <string>
#include <vector>

#include "engine/figure/body_role.h"

namespace hazumi::ui {

// "left forearm", in the interface's language.
std::string TextOf(BodyPlace place);

// All that a bone can be, each on the sides where a body may have it.
std::vector<BodyPlace> AllPlaces();

}  // namespace hazumi::ui
