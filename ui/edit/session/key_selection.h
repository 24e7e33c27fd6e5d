#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "engine/project/project.h"

namespace hazumi::edit {

// Keys by the name of their curve and their frame. No curve is in it without frames.
using KeySelection = std::map<std::string, std::set<double>>;

bool Contains(const KeySelection& keys, const std::string& curve, double frame);
size_t NumKeys(const KeySelection& keys);
// Memory that it holds, about.
size_t BytesOf(const KeySelection& keys);

// Leaves those that the project has.
void DropMissing(const Project& project, KeySelection* keys);

}  // namespace hazumi::edit
