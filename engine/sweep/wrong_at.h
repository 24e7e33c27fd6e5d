#pragma once

// Internal.

#include <string>

#include "engine/base/result.h"

namespace hazumi {

// Of a place in a sweep file.
inline Error WrongAt(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

}  // namespace hazumi
