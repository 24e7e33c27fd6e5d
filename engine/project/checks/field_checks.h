#pragma once

// Internal. Checks of single values and of the names in a list, shared by figures and projects.

#include <map>
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

// Names of one list: none twice.
template <typename Items>
void CheckNamesUnique(const Items& items, const Site& site) {
  std::map<std::string, size_t> places;
  for (size_t i = 0; i < items.size(); ++i) {
    const auto [it, fresh] = places.emplace(items[i].name, i);
    if (fresh) continue;
    site.Item(i).Field("name").Report(Check::kNameTwice,
                                      {Quoted(items[i].name), site.Item(it->second).place});
  }
}

}  // namespace hazumi
