#pragma once

#include <string>
#include <string_view>

namespace hazumi::edit {

// FNV-1a, 64 bits, in hexadecimal.
std::string DigestOf(std::string_view text);
// Of what a project's file holds; empty if it cannot be read.
std::string DigestOfFile(const std::string& path);

}  // namespace hazumi::edit
