#pragma once

#include <string>
#include <vector>

#include "engine/exchange/bvh/bvh_file.h"

namespace hazumi::test {

// Four joints of different rotation orders, three frames at 24 fps, LF, no blank line at the end.
std::string SmallBvh();
// The last row of SmallBvh, with its line end.
std::string LastRow();

// `text` with `from`, which must be in it once at least, replaced throughout.
std::string Replaced(std::string text, const std::string& from, const std::string& to);

// What must be read, with a failed test and an empty character where it cannot.
Character ReadWell(std::string_view text);
// All warnings, one a line, as "line 5: message".
std::string Warnings(const Character& character);

// Bones and clips are the same: names, tree, orders; lengths and angles [rad] within `tolerance`.
void ExpectSame(const Character& a, const Character& b, double tolerance);
// Numbers are finite, quaternions unit, lists as long as they must be, parents before children.
void ExpectSound(const Character& character);

// Origins of all bones at a frame, in the file's axes and unit.
std::vector<Vec3> Positions(const Character& character, int frame);

}  // namespace hazumi::test
