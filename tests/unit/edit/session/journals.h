#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/recovery/journal.h"
#include "ui/edit/recovery/recovery.h"

namespace hazumi::test {

using std::chrono::milliseconds;

inline std::string TextOf(const edit::Session& session) { return WriteProject(session.project()); }

// So much after the beginning of a test's time.
inline edit::Journal::Time At(double seconds) {
  return edit::Journal::Time(milliseconds(static_cast<long>(seconds * 1000.0)));
}

inline void Tick(edit::Journal* journal, double seconds) {
  const Result<Done> ticked = journal->Tick(At(seconds));
  EXPECT_TRUE(ticked.ok()) << (ticked.ok() ? "" : ticked.error().ToString());
}

inline std::vector<edit::AbandonedJournal> Abandoned(const std::string& folder) {
  const auto journals = edit::FindAbandonedJournals(folder);
  EXPECT_TRUE(journals.ok());
  return journals.ok() ? journals.value() : std::vector<edit::AbandonedJournal>();
}

// Of the only journal that was left behind.
inline edit::Recovered Recover(const std::string& folder, edit::Session* session) {
  const std::vector<edit::AbandonedJournal> journals = Abandoned(folder);
  EXPECT_EQ(journals.size(), 1u);
  if (journals.size() != 1) return {};
  const Result<edit::Recovered> recovered = edit::RecoverJournal(journals[0].file, session);
  EXPECT_TRUE(recovered.ok()) << (recovered.ok() ? "" : recovered.error().ToString());
  return recovered.ok() ? recovered.value() : edit::Recovered();
}

}  // namespace hazumi::test
