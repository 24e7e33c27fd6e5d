#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hazumi {

// RFC 4648, with padding.
std::string ToBase64(std::string_view bytes);
// Padding may be missing. Nothing: a letter that does not belong there, or one too many or too few.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace hazumi
