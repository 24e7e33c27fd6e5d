#include "engine/base/utf8.h"
#include "engine/project/json/json.h"

namespace hazumi {

namespace {

constexpr size_t kColumns = 100;

void AppendEscaped(char c, std::string* out) {
  constexpr char kHex[] = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(c);
  if (c == '"' || c == '\\') {
    (*out += '\\') += c;
  } else if (c == '\n') {
    *out += "\\n";
  } else if (c == '\t') {
    *out += "\\t";
  } else if (code < 0x20) {
    ((*out += "\\u00") += kHex[code >> 4]) += kHex[code & 15];
  } else {
    *out += c;
  }
}

std::string StringText(const std::string& value) {
  std::string text = "\"";
  for (char c : ValidUtf8(value)) AppendEscaped(c, &text);
  return text + '"';
}

std::string ScalarText(const Json& json) {
  if (json.is_string()) return StringText(json.get_ref<const std::string&>());
  if (!json.is_number_float()) return json.dump();
  const double value = json.get<double>();
  return value - value == 0.0 ? NumberText(value) : "null";  // JSON has no infinity
}

// Calls visit(prefix, child): the prefix is `"name": ` in an object.
template <typename Visit>
void ForEachChild(const Json& json, Visit visit) {
  for (const auto& item : json.items()) {
    visit(json.is_object() ? StringText(item.key()) + ": " : std::string(), item.value());
  }
}

// Appends the value on one line; stops early once `out` is longer than `limit`.
void AppendCompact(const Json& json, size_t limit, std::string* out) {
  if (!json.is_structured()) {
    *out += ScalarText(json);
    return;
  }
  *out += json.is_object() ? '{' : '[';
  bool first = true;
  ForEachChild(json, [&](const std::string& prefix, const Json& child) {
    if (out->size() > limit) return;
    (*out += first ? "" : ", ") += prefix;
    AppendCompact(child, limit, out);
    first = false;
  });
  *out += json.is_object() ? '}' : ']';
}

// Appends the value at a column; `reserved` columns must stay free behind it (for a comma).
void AppendPretty(const Json& json, size_t indent, size_t column, size_t reserved,
                  std::string* out) {
  const size_t room = kColumns - std::min(kColumns, column + reserved);
  std::string line;
  AppendCompact(json, room, &line);
  if (!json.is_structured() || json.empty() || line.size() <= room) {
    *out += line;
    return;
  }
  const std::string margin(indent + 2, ' ');
  *out += json.is_object() ? '{' : '[';
  bool first = true;
  ForEachChild(json, [&](const std::string& prefix, const Json& child) {
    ((*out += first ? "\n" : ",\n") += margin) += prefix;
    AppendPretty(child, indent + 2, margin.size() + prefix.size(), 1, out);
    first = false;
  });
  (*out += '\n').append(indent, ' ') += json.is_object() ? '}' : ']';
}

}  // namespace

std::string FormatJson(const Json& json) {
  std::string text;
  AppendPretty(json, 0, 0, 0, &text);
  return text + '\n';
}

std::string CompactJson(const Json& json) {
  std::string text;
  AppendCompact(json, std::string::npos, &text);
  return text;
}

}  // namespace hazumi
