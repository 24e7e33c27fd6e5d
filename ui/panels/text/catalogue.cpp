#include "ui/panels/text/catalogue.h"

#include <span>
#include <unordered_map>

namespace hazumi::ui {

namespace {

struct Entry {
  const char* english;
  const char* japanese;
};

// The translations are a gettext file: lines `msgid "English"` and `msgstr "..."`, whose strings
// are those of C. It has no comments, so that it can be compiled as it is.
// clang-format off
constexpr Entry kFile[] = {{nullptr, nullptr
#define msgid }, {
#define msgstr ,
#include "assets/translations/ja.po"
#undef msgid
#undef msgstr
}};
// clang-format on

// The first entry of the file is its header.
constexpr std::span<const Entry> kEntries = std::span(kFile).subspan(2);

Language g_language = Language::kEnglish;  // one interface, one language

const std::unordered_map<std::string_view, const char*>& Japanese() {
  static const auto table = [] {
    std::unordered_map<std::string_view, const char*> map;
    for (const Entry& entry : kEntries) map.emplace(entry.english, entry.japanese);
    return map;
  }();
  return table;
}

}  // namespace

void SetLanguage(Language language) { g_language = language; }
Language CurrentLanguage() { return g_language; }

const char* Tr(const char* english) {
  if (g_language == Language::kEnglish) return english;
  const auto found = Japanese().find(english);
  return found == Japanese().end() ? english : found->second;
}

std::vector<std::string_view> CatalogueKeys() {
  std::vector<std::string_view> keys;
  for (const Entry& entry : kEntries) keys.push_back(entry.english);
  return keys;
}

}  // namespace hazumi::ui
