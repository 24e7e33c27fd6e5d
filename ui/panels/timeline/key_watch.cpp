#include "ui/panels/timeline/key_watch.h"

namespace hazumi::ui {

void TurnWatch::Look(edit::Session* session) {
  const long document = session->document_number(), revision = session->document().revision();
  if (document != document_) turns_.clear();
  if ((document == document_ && revision == revision_) || session->document().is_merging()) return;
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return;  // retry at the next call
  document_ = document;
  revision_ = revision;
  turns_ = FindHeldTurns(*session->animation(), *motion.value());
}

}  // namespace hazumi::ui
