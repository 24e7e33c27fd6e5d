#pragma once

// Keys that are selected, and what goes along with them.

#include <cstddef>
#include <functional>
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

// Returns the new frame of a frame.
using FrameMap = std::function<double(double)>;

// Moves what goes along with selected keys that are about to be moved in time. If they are all keys
// from the first to the last of them, everything else with a frame in between goes to the nearest
// whole frame there: ends of regions, placements, holds, forces and constraints, markers, and
// frames in which objects are let go. If they are all keys of the joints of one region or fill, the
// ends of that go. Keys on a single frame take nothing along.
void CarryAlong(const KeySelection& selected, const Figure& figure, const FrameMap& to,
                Project* project);

}  // namespace hazumi
