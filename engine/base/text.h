#pragma once

#include <array>
#include <charconv>
#include <string>

namespace hazumi {

// The shortest decimal that reads back as the same double; "-0" is written "0".
inline std::string FormatNumber(double value) {
  if (value == 0.0) return "0";
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
}

}  // namespace hazumi
