#pragma once

#include <vector>

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

}  // namespace hazumi::ui
