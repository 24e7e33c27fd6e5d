#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

// The shortest decimal that reads back as the same double; "-0" is written "0".
inline std::string FormatNumber(double value) {
  if (value == 0.0) return "0";
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
}

// For messages: three significant digits, and never fewer than stand before the point.
inline std::string FormatShort(double value) {
  const double magnitude = std::abs(value);
  if (!(magnitude >= 1e-300 && magnitude < 1e15)) return FormatNumber(value);
  const int digits = std::max(3, 1 + static_cast<int>(std::floor(std::log10(magnitude))));
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return std::string(buffer.data(), end);
}

inline std::vector<std::uint8_t> BytesOf(std::string_view text) {
  return {text.begin(), text.end()};
}

// Of ASCII; other letters keep their case.
inline std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace hazumi
