#pragma once

#include "engine/project/project.h"

namespace hazumi::edit {

// The human that comes with Hazumi, standing on the ground, written into the project so that it
// needs no other file; 30 frames a second, frames 0 to 30.
Project NewProject();

}  // namespace hazumi::edit
