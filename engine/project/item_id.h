#pragma once

#include "engine/base/typed_index.h"

namespace hazumi {

// Tells an item of one of the document's lists from all others as long as the document is open,
// whatever it is called and wherever it stands. Files do without: they have names.
using ItemId = TypedIndex<struct ItemTag>;

// The id of an item. No part of what the document says: never written, and equal to any other.
struct Identity {
  ItemId id;
  bool operator==(const Identity&) const { return true; }
};

// The index of an item in its list; -1 if it is not there.
template <typename List>
int IndexOf(ItemId id, const List& items) {
  for (size_t i = 0; i < items.size(); ++i) {
    if (id.is_valid() && items[i].identity.id == id) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace hazumi
