#pragma once

#include <vector>

#include "engine/analysis/held_turn.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Finds regions in which keys hold the root's turn against gravity and contacts. Looks at a
// document once after each edit, and only if it has such a region.
class TurnWatch {
 public:
  // While something is dragged nothing new is looked for.
  void Look(edit::Session* session);
  // Of the motion that was looked at last; none of another document.
  const std::vector<HeldTurn>& turns() const { return turns_; }

 private:
  long document_ = -1, revision_ = -1;
  std::vector<HeldTurn> turns_;
};

}  // namespace hazumi::ui
