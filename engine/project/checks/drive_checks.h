#pragma once

// Internal. What must hold of the drives of a region.

#include "engine/project/checks/checks.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/json/site.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// By themselves, and their names.
void CheckDriveNames(const ProjectRegion& region, const Figure& figure, const Site& region_site);
// What its curves say between their keys. Needs a frame rate that has been checked.
void CheckDriveCurves(const ProjectDrive& drive, const ProjectRate& rate, const Site& site);
// Beside what is known of the region's joints.
void CheckDrives(const Animation& animation, size_t region, FirstError* errors);

}  // namespace hazumi
