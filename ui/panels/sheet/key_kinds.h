#pragma once

#include <vector>

#include "ui/edit/parameters.h"

namespace hazumi::ui {

// What keys can be set to, by which operator, as menus and small windows offer it.
struct KeyChoice {
  const char* id;
  edit::Json parameters;
  const char* label;
  bool begins_group = false;  // a line above it
};
const std::vector<KeyChoice>& InterpolationChoices();
const std::vector<KeyChoice>& HandleChoices();
const std::vector<KeyChoice>& KeyTypeChoices();

}  // namespace hazumi::ui
