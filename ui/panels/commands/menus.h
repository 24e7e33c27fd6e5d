#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// An entry of a menu: an action or operator with parameters, a line (no id, no label), or a menu of
// its own (no id, a label).
struct MenuEntry {
  const char* id = nullptr;
  Json parameters = Json::object();
  const char* label = nullptr;  // English; not given: that of the action or operator
  std::vector<MenuEntry> entries = {};
};

// The menu bar, from left to right.
const std::vector<MenuEntry>& AllMenus();
// Every entry that does something, also those of menus in menus.
std::vector<MenuEntry> FlatMenus();

// As it is shown, in the interface's language, with dots behind it if something is asked first.
std::string LabelOf(const MenuEntry& entry);
// Undo and redo say what.
std::string LabelOf(const MenuEntry& entry, const Editor& editor);
// Whether it can be done now; what cannot is grey.
bool CanDo(const Editor& editor, const std::string& id);
// Of an entry that is on or off: which. None for others.
std::optional<bool> IsOn(const Editor& editor, const MenuEntry& entry);

}  // namespace hazumi::ui
