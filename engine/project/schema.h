#pragma once

#include <string>

namespace hazumi {

// The JSON schema (draft 7) of .kfa files, made of the descriptions of their fields.
std::string ProjectSchema();

}  // namespace hazumi
