#pragma once

#include <string>

#include "engine/region/work.h"

namespace hazumi {

// Message that a bake ended at its limit of work: what most of it went into, and the remedy.
std::string TooMuch(const Work& work);

}  // namespace hazumi
