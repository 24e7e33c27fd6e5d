#pragma once

// Internal: what operators are made of that key a whole move, such as a jump.

#include <optional>
#include <string>
#include <vector>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// The hinges of these names are what the poses of a move are of. Errors: kSchema.
std::optional<Error> CheckHinges(const std::vector<std::string>& names, const std::string& whose,
                                 const Figure& figure);
// No region moves joints in frames first to last. Errors: kSchema, with what it is called to do
// elsewhere.
std::optional<Error> CheckFreeOfRegions(int first, int last, const std::string& instead,
                                        const Project& project);

void RemoveKeysIn(int first, int last, ProjectCurve* curve);
// Of a joint [deg, deg/s] or the root [m, m/s].
void KeyMove(int frame, double value, std::optional<double> rate, ProjectCurve* curve);
// So many seconds, at least so many frames.
int FramesOf(double seconds, int least, const Animation& animation);

}  // namespace hazumi::edit
