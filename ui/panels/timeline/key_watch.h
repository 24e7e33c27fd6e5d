#pragma once

// Finds what keys do to the figure that no body could: sinking into the ground, not turning as it
// falls.

#include <vector>

#include "engine/analysis/held_turn.h"
#include "engine/analysis/problems/sinking.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Finds frames in which keys or a pin put the figure into the ground, few at a time, so that it
// costs a redraw next to nothing.
class GroundWatch {
 public:
  // Evaluates at most `most` frames that are not known yet.
  void Look(edit::Session* session, int most) {
    const Version now = {session->document_number(), session->document().revision()};
    if (is_done_ && now == seen_) return;
    is_done_ = true;
    const Result<const Motion*> motion = session->WholeMotion();
    if (!motion.ok()) return;  // it may be there the next time
    seen_ = now;
    is_done_ = finder_.Look(*session->animation(), *motion.value(), most);
  }
  // Whether all frames of the document are known, as it was at the latest Look.
  bool is_done() const { return is_done_; }
  const std::vector<Sinking>& sinkings() const { return finder_.sinkings(); }

 private:
  // A document between two edits.
  struct Version {
    long document = -1, revision = -1;
    bool operator==(const Version&) const = default;
  };

  Version seen_;
  bool is_done_ = true;
  SinkingFinder finder_;
};

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
