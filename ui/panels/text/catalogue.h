#pragma once

#include <string_view>
#include <vector>

namespace hazumi::ui {

enum class Language { kEnglish, kJapanese };

// The language of the interface, for all windows of the program.
void SetLanguage(Language language);
Language CurrentLanguage();

// A text of the interface in the current language. The English text is the key; one that the
// catalogue does not have stays English (a test makes sure that there is none).
const char* Tr(const char* english);

// All English texts that the catalogue has.
std::vector<std::string_view> CatalogueKeys();

}  // namespace hazumi::ui
