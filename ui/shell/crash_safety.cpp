#include "ui/shell/crash_safety.h"

#include <limits>

namespace hazumi::ui {

using Clock = std::chrono::steady_clock;

CrashSafety::CrashSafety(Editor* editor, const std::string& state_folder) : editor_(editor) {
  if (state_folder.empty()) return;
  folder_ = state_folder + "/journals";
  journal_ = std::make_unique<edit::Journal>(&editor->session(), folder_);
}

void CrashSafety::LookForCrash() {
  if (!journal_) return;
  auto found = edit::FindAbandonedJournals(folder_);
  if (!found.ok()) return editor_->Say(found.error().ToString(), true);
  editor_->recovery.journals = std::move(found).value();
  editor_->recovery.answer = [this](const edit::AbandonedJournal& journal, bool recovers) {
    Answer(journal, recovers);
  };
}

// What was recovered is in a journal of ours before the old one goes.
void CrashSafety::Answer(const edit::AbandonedJournal& journal, bool recovers) {
  if (recovers) {
    const Result<edit::Recovered> recovered =
        edit::RecoverJournal(journal.file, &editor_->session());
    if (!recovered.ok()) return editor_->Say(recovered.error().ToString(), true);
    const Result<Done> written = journal_->WriteNow(Clock::now());
    if (!written.ok()) return editor_->Say(written.error().ToString(), true);
    if (recovered.value().damage) editor_->Say(recovered.value().damage->ToString(), true);
  }
  const Result<Done> discarded = edit::DiscardJournal(journal.file);
  if (!discarded.ok()) editor_->Say(discarded.error().ToString(), true);
}

void CrashSafety::Tick() {
  if (!journal_) return;
  const Result<Done> done = journal_->Tick(Clock::now());
  if (!done.ok()) editor_->Say(done.error().ToString(), true);
}

double CrashSafety::NextDeadline() const {
  const auto deadline = journal_ ? journal_->next_deadline() : std::nullopt;
  if (!deadline) return std::numeric_limits<double>::infinity();
  return std::chrono::duration<double>(*deadline - Clock::now()).count();
}

void CrashSafety::Close() {
  if (!journal_) return;
  const Result<Done> done = journal_->Discard();
  if (!done.ok()) editor_->Say(done.error().ToString(), true);
}

}  // namespace hazumi::ui
