#pragma once

// Internal. Clips in messages.

#include <string>
#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

// A name in quotation marks, as much of it as a line of text has room for.
std::string Quoted(const std::string& name);

// The names of the first hundred clips, and how many more there are.
std::string NamesOf(const std::vector<Clip>& clips);

}  // namespace hazumi
