#pragma once

// Internal. Checks of single values, shared by figures and projects.

#include <string>

#include "engine/project/fields/field.h"
#include "engine/project/json/site.h"
#include "engine/spatial/types.h"

namespace hazumi {

void CheckPositive(double value, const Site& site);
void CheckPositive(const Vec3& value, const Site& site);  // each component
void CheckNotNegative(double value, const Site& site);
// Finite, and in the field's range.
bool IsWithin(double value, const NumberRange& range);
void CheckRange(double value, const Field& field, const Site& site);
void CheckUnitVector(const Vec3& value, const Site& site);
void CheckColor(const std::string& color, const Site& site);
void CheckNotEmpty(const std::string& name, const Site& site);

}  // namespace hazumi
