#include "engine/sweep/short_decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hazumi {

std::string ShortDecimal(const std::string& text, int digits) {
  double value = 0.0;
  const auto [read, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  constexpr double kMost = 1e15;
  if (failed != std::errc() || read != text.data() + text.size()) return text;
  if (!(std::abs(value) < kMost)) return text;
  const double magnitude = std::max(1.0, std::abs(value));
  digits = std::max(digits, 1 + static_cast<int>(std::floor(std::log10(magnitude))));
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return {buffer.data(), end};
}

std::vector<std::string> ShortDecimals(const std::vector<std::string>& texts) {
  constexpr int kLeast = 3, kMost = 12;
  for (int digits = kLeast; digits < kMost; ++digits) {
    std::vector<std::string> shorter;
    bool are_told = true;
    for (size_t i = 0; i < texts.size(); ++i) {
      shorter.push_back(ShortDecimal(texts[i], digits));
      const bool differs = i > 0 && texts[i] != texts[i - 1];
      are_told = are_told && (!differs || shorter[i] != shorter[i - 1]);
    }
    if (are_told) return shorter;
  }
  return texts;
}

}  // namespace hazumi
