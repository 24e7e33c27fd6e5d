#pragma once

#include <vector>

#include "engine/analysis/held_turn.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Finds regions in which keys hold the root's orientation against gravity and contacts. Evaluates a
// document once after each edit, and only if it has such a region.
class TurnWatch {
 public:
  // Updates the result; does nothing during a drag.
  void Look(edit::Session* session);
  // Result for the motion evaluated last; empty for another document.
  const std::vector<HeldTurn>& turns() const { return turns_; }

 private:
  long document_ = -1, revision_ = -1;
  std::vector<HeldTurn> turns_;
};

}  // namespace hazumi::ui
