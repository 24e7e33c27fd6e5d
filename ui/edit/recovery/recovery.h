#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// A journal that a crash left behind.
struct AbandonedJournal {
  std::string file;
  std::string path;  // of the project; empty: it had none
  std::chrono::system_clock::time_point written;
  int num_operators = 0;
  // The project's file was written after the journal: it may hold more.
  bool is_project_newer = false;
  std::optional<Error> damage;  // nothing can be recovered

  std::string project() const { return path.empty() ? "untitled" : path; }
};

// Those of a folder that no Hazumi which runs has, the newest first. None if there is no such
// folder. Error: kNoInput.
Result<std::vector<AbandonedJournal>> FindAbandonedJournals(const std::string& folder);

// What was recovered of a journal.
struct Recovered {
  int num_operators = 0;
  bool is_cut_off = false;  // a last line, in the midst of writing; it was left out
  // Where the rest could not be done, with file and line, and what became of it.
  std::optional<Error> damage;
};

// Makes the document of a journal that of the session: not saved, its path kept, nothing to undo
// but what the journal holds. The journal stays until it is discarded. Errors: the session is as it
// was.
Result<Recovered> RecoverJournal(const std::string& file, Session* session);

// Errors: kFailed if a Hazumi which runs has it.
Result<Done> DiscardJournal(const std::string& file);

// Returns the folder for data that outlives the program and is no document: $XDG_STATE_HOME/hazumi,
// else ~/.local/state/hazumi. `variable` looks up the environment and may give null: std::getenv.
// Error: kFailed if there is no home either.
Result<std::string> StateFolder(const std::function<const char*(const char* name)>& variable);

}  // namespace hazumi::edit
