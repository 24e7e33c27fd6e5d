#pragma once

#include <memory>
#include <string>

#include "ui/edit/recovery/journal.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Keeps a journal of an editor's session, and offers what an earlier one left behind.
class CrashSafety {
 public:
  // `state_folder`: journals are kept below it; empty: nothing is kept.
  CrashSafety(Editor* editor, const std::string& state_folder);

  // Asks the user about journals that no one has any more.
  void LookForCrash();
  // Writes what is due, after each frame.
  void Tick();
  // Seconds until there is something to write; a large number if there is nothing.
  double NextDeadline() const;
  // The editor was left in order: what is not saved is not wanted.
  void Close();

 private:
  void Answer(const edit::AbandonedJournal& journal, bool recovers);

  Editor* editor_;
  std::string folder_;
  std::unique_ptr<edit::Journal> journal_;
};

}  // namespace hazumi::ui
