#include "engine/sweep/csv.h"

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

}  // namespace hazumi
