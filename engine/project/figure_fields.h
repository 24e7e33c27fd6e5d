#pragma once

// Internal. A figure's JSON.

#include "engine/figure/figure_spec.h"
#include "engine/project/json/field_reader.h"

namespace hazumi {

// True if the object says it is of this format, of a version up to the newest; else reports
// `other_format` or what is wrong with the version.
bool ExpectFormat(const Json& json, const char* format, int newest, Check other_format,
                  const Site& site);

// Reads, checks and tries to build a figure. What is returned after a report is of no use.
FigureSpec ReadFigure(const Json& json, const Site& site);

// R = Rz Ry Rx from its angles z, y, x [deg].
Mat3 RotationFromAngles(const Vec3& zyx_deg);

}  // namespace hazumi
