#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "ui/edit/recovery/locked_file.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

struct JournalTimes {
  // From the first change that is not yet on the disk until it is.
  std::chrono::milliseconds write_after{2'000};
  // From the first change after a snapshot until the next one.
  std::chrono::milliseconds autosave_after{120'000};
};

// Keeps what is not saved on the disk, so that a crash loses little: a snapshot of the document and
// the operators that were run since, in a file that the journal has locked (recovery.h finds those
// that no one has). There is a file only while something is not saved.
//
// The snapshot is the document as it was opened or saved, or as of the last autosave. Operators
// named "file." are not replayed, for files change: after one a new snapshot is taken. So it is
// after an undo beyond the snapshot, and when the document changed other than by an operator.
class Journal {
 public:
  using Time = std::chrono::steady_clock::time_point;

  // Journals go to `folder`, which is made when there is something to write. The session must
  // outlive this. Without Discard() the file stays when this goes, as after a crash.
  Journal(Session* session, std::string folder, JournalTimes times = {});
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // Writes what is due. To be called after operators have run and at next_deadline(). An error
  // (kCannotWrite) loses nothing: it is tried again.
  Result<Done> Tick(Time now);
  // None: nothing will be due before another operator is run.
  std::optional<Time> next_deadline() const;
  // Writes what there is, due or not; after a recovery, before the old journal is discarded.
  Result<Done> WriteNow(Time now);

  // What is not saved is not wanted. Nothing is observed any more.
  Result<Done> Discard();

  // Empty if there is none.
  std::string file() const { return file_ ? file_->path() : ""; }

 private:
  void BeforeRun();
  void AfterRun(const std::string& id, const Json& parameters);
  bool is_other_document() const;
  void TakeBase();
  void NoteSessionState();
  bool is_due_to_write() const;
  void StartClocks(Time now);
  Result<Done> RemoveIfSaved();
  Result<Done> Write(Time now);
  Result<Done> WriteLines();

  Session* session_;
  std::string folder_;
  JournalTimes times_;
  std::shared_ptr<const SessionObserver> observer_;  // null: discarded
  std::optional<LockedFile> file_;

  std::string base_;  // .kfa text
  Json base_state_;
  long document_number_ = -1, base_revision_ = -1;
  // As last seen.
  long revision_ = -1;
  Json state_;

  bool begins_anew_ = true;  // the file, if any, is not of this base
  std::string pending_;      // lines that are not in the file
  // Of the first change that is not in the file, and of the first since the base.
  std::optional<Time> first_unwritten_, first_change_;
};

}  // namespace hazumi::edit
