#pragma once

// Internal. What must hold of a project by itself: ranges, order, names given twice.

#include "engine/figure/figure.h"
#include "engine/project/checks/checks.h"
#include "engine/project/json/site.h"
#include "engine/project/project.h"

namespace hazumi {

// Checks the whole document, whatever the figure.
void CheckDocument(const Project& project, FirstError* errors);

// Checks the drives of a region by themselves, and the names of their joints.
void CheckDriveNames(const ProjectRegion& region, const Figure& figure, const Site& region_site);
// Checks what the curves of a drive say between their keys. Needs a frame rate that has been
// checked.
void CheckDriveCurves(const ProjectDrive& drive, const ProjectRate& rate, const Site& site);

}  // namespace hazumi
