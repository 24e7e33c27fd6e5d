#pragma once

// Internal. Names: of clips in messages, and those that a project can hold.

#include <string>
#include <vector>

#include "engine/exchange/character/character.h"
#include "engine/exchange/import/import_project.h"

namespace hazumi {

// A name in quotation marks, as much of it as a line of text has room for.
std::string Quoted(const std::string& name);

// The names of the first hundred clips, and how many more there are.
std::string NamesOf(const std::vector<Clip>& clips);

// "x", "y" or "z" by the axis that a hinge turns about.
std::string HingeName(int axis);

// Names of the root, the first one, and of joints, made from those of their bones: no two names are
// the same, hinges ("A_x") among them; none is empty, holds control characters or ends in "+",
// which means all beyond. A name that is changed is a warning.
std::vector<std::string> FigureNames(const std::vector<std::string>& bones, ImportReport* report);

}  // namespace hazumi
