#pragma once

// UTF-8 as in RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF.

#include <cstddef>
#include <string>
#include <string_view>

namespace hazumi {

// Where the first malformed sequence begins; npos if there is none.
size_t FindInvalidUtf8(std::string_view text);

// The text with every malformed byte replaced by U+FFFD.
std::string ValidUtf8(std::string_view text);

// The code points of the text; every malformed byte becomes U+FFFD.
std::u32string DecodeUtf8(std::string_view text);

}  // namespace hazumi
