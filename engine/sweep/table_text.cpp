#include "engine/sweep/table_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hazumi {

namespace {

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// A field from `at` on, which is moved behind it.
std::string ReadField(std::string_view text, size_t* at) {
  std::string field;
  if (*at >= text.size() || text[*at] != '"') {
    const size_t end = std::min(text.find_first_of(",\n", *at), text.size());
    field = text.substr(*at, end - *at);
    *at = end;
    if (field.ends_with('\r')) field.pop_back();
    return field;
  }
  for (++*at; *at < text.size(); ++*at) {
    if (text[*at] == '"' && (*at + 1 >= text.size() || text[*at + 1] != '"')) break;
    if (text[*at] == '"') ++*at;
    field += text[*at];
  }
  *at = std::min(text.find_first_of(",\n", *at), text.size());
  return field;
}

}  // namespace

std::string CsvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (size_t i = 0; i < fields.size(); ++i) line += (i > 0 ? "," : "") + CsvField(fields[i]);
  return line + "\n";
}

std::vector<std::vector<std::string>> ReadCsv(std::string_view text) {
  std::vector<std::vector<std::string>> lines;
  for (size_t at = 0; at < text.size(); ++at) {
    std::vector<std::string>& line = lines.emplace_back();
    line.push_back(ReadField(text, &at));
    while (at < text.size() && text[at] == ',') {
      ++at;
      line.push_back(ReadField(text, &at));
    }
  }
  return lines;
}

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
