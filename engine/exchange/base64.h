#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hazumi {

// RFC 4648, with padding.
std::string ToBase64(std::string_view bytes);
// Padding may be missing. Empty: a letter that does not belong there.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace hazumi
