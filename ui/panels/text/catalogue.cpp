#include "ui/panels/text/catalogue.h"

#include <unordered_map>

namespace hazumi::ui {

namespace {

struct Entry {
  const char* english;
  const char* japanese;
};

constexpr Entry kEntries[] = {
#include "ui/panels/text/catalogue_entries.inc"
};

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
