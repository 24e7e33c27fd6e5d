#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace hazumi {

// A text of the catalogue with its places filled, as printf does it; 300 bytes at most.
template <typename... Values>
std::string Filled(const char* format, Values... values) {
  std::array<char, 301> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace hazumi
