#pragma once

#include <string>
#include <string_view>

namespace hazumi::render {

// The code points of a text; a byte that is not valid UTF-8 becomes U+FFFD.
std::u32string DecodeUtf8(std::string_view text);

}  // namespace hazumi::render
