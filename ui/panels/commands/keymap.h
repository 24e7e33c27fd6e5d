#pragma once

#include <vector>

#include "ui/panels/commands/keys.h"

namespace hazumi::ui {

// A key that the user has changed: who has `original` by default in that place has `chord`, which
// may be none.
struct KeyChange {
  Place place = Place::kAnywhere;
  Chord original, chord;
  bool operator==(const KeyChange&) const = default;
};
using Keymap = std::vector<KeyChange>;

// The keys of the interface, for all windows of the program.
void SetKeymap(const Keymap& keymap);

// Gives who has `original` by default in a place another key; back to the default if it is that
// one. Who had that key there has none afterwards; that one's default key, or none if the key was
// free.
Chord ChangeKey(const KeyChange& change, Keymap* keymap);

}  // namespace hazumi::ui
