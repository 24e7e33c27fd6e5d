#pragma once

#include <vector>

namespace hazumi::ui {

// A part of the manual, in English.
struct ManualPart {
  const char* title;
  std::vector<const char*> paragraphs;
};
const std::vector<ManualPart>& ManualParts();

}  // namespace hazumi::ui
