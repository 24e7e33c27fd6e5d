#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "engine/project/project.h"

namespace hazumi {

// Keys by the name of their curve and their frame. Each curve in it has frames.
using KeySelection = std::map<std::string, std::set<double>>;

bool Contains(const KeySelection& keys, const std::string& curve, double frame);
size_t NumKeys(const KeySelection& keys);
// Returns about how much memory it holds.
size_t BytesOf(const KeySelection& keys);

// Removes keys that the project does not have.
void DropMissing(const Project& project, KeySelection* keys);

}  // namespace hazumi
