#include "ui/edit/recovery/journal.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "engine/project/project_writer.h"
#include "ui/edit/recovery/journal_format.h"
#include "ui/edit/session/session_state.h"

namespace hazumi::edit {

namespace {

namespace fs = std::filesystem;

// A name that no other journal has or had.
std::string NewFile(const std::string& folder) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  return folder + "/" + std::to_string(ns) + "-" + std::to_string(::getpid()) + ".journal";
}

std::string Absolute(const std::string& path) {
  if (path.empty()) return path;
  std::error_code failed;
  const fs::path absolute = fs::absolute(path, failed);
  return failed ? path : absolute.lexically_normal().string();
}

// For the user's eyes only, if it has to be made.
Result<Done> MakeFolder(const std::string& folder) {
  std::error_code failed;
  const bool is_new = fs::create_directories(folder, failed);
  if (!failed && is_new) fs::permissions(folder, fs::perms::owner_all, failed);
  if (!failed) return Done();
  return Error{ErrorCode::kCannotWrite, folder, "",
               "the folder of journals cannot be made: " + failed.message()};
}

}  // namespace

Journal::Journal(Session* session, std::string folder, JournalTimes times)
    : session_(session), folder_(std::move(folder)), times_(times) {
  TakeBase();
  observer_ =
      session->Observe({.before = [this] { BeforeRun(); },
                        .after = [this](const std::string& id,
                                        const Json& parameters) { AfterRun(id, parameters); }});
}

bool Journal::is_other_document() const { return document_number_ != session_->document_number(); }

// The document as it is now is where a replay begins.
void Journal::TakeBase() {
  Document& document = session_->document();
  // What was waiting to be written is part of the snapshot and waits no longer for it.
  if (is_other_document() || document.is_saved()) first_unwritten_.reset();
  if (is_other_document() || base_revision_ != document.revision()) {
    base_ = WriteProject(document.project());
    base_revision_ = document.revision();
  }
  document_number_ = session_->document_number();
  revision_ = document.revision();
  base_state_ = state_ = StateOf(*session_);
  document.MarkBase();
  begins_anew_ = true;
  pending_.clear();
  first_change_.reset();
}

void Journal::NoteSessionState() {
  Json state = StateOf(*session_);
  if (state == state_) return;
  state_ = std::move(state);
  if (session_->document().is_saved()) {
    base_state_ = state_;
  } else {
    pending_ += StateLine(state_);
  }
}

// What changed since the last operator, and not by one.
void Journal::BeforeRun() {
  if (is_other_document() || revision_ != session_->document().revision()) {
    TakeBase();
  } else {
    NoteSessionState();
  }
}

void Journal::AfterRun(const std::string& id, const Json& parameters) {
  const Document& document = session_->document();
  if (is_other_document() || document.is_saved() || document.has_left_base()) return TakeBase();
  if (id.starts_with("file.")) return BeforeRun();
  pending_ += OperatorLine(id, parameters);
  revision_ = document.revision();
  state_ = StateOf(*session_);
}

bool Journal::is_due_to_write() const {
  return !session_->document().is_saved() && (begins_anew_ || !pending_.empty());
}

void Journal::StartClocks(Time now) {
  if (is_due_to_write() && !first_unwritten_) first_unwritten_ = now;
  if (!pending_.empty() && !first_change_) first_change_ = now;
}

Result<Done> Journal::RemoveIfSaved() {
  if (!session_->document().is_saved()) return Done();
  if (!begins_anew_ || !pending_.empty()) TakeBase();  // saved by no operator
  if (!file_) return Done();
  Result<Done> removed = file_->Remove();
  file_.reset();
  return removed;
}

Result<Done> Journal::Tick(Time now) {
  if (!observer_) return Done();
  BeforeRun();
  Result<Done> removed = RemoveIfSaved();
  if (!removed.ok()) return removed;
  StartClocks(now);
  const bool is_autosave_due = first_change_ && now - *first_change_ >= times_.autosave_after;
  if (is_autosave_due && !session_->document().is_merging()) {
    TakeBase();
    return Write(now);
  }
  if (first_unwritten_ && now - *first_unwritten_ >= times_.write_after) return Write(now);
  return Done();
}

// In a drag no autosave is waited for: an operator will end it.
std::optional<Journal::Time> Journal::next_deadline() const {
  std::optional<Time> next;
  if (first_unwritten_) next = *first_unwritten_ + times_.write_after;
  if (first_change_ && !session_->document().is_merging()) {
    const Time autosave = *first_change_ + times_.autosave_after;
    next = next ? std::min(*next, autosave) : autosave;
  }
  return next;
}

Result<Done> Journal::WriteNow(Time now) {
  const Result<Done> ticked = Tick(now);
  return ticked.ok() && first_unwritten_ ? Write(now) : ticked;
}

Result<Done> Journal::Write(Time now) {
  // Someone removed it. What was in it is in a new snapshot, but no replay may begin in a drag.
  if (!begins_anew_ && !file_->is_in_place() && !session_->document().is_merging()) TakeBase();
  Result<Done> written = WriteLines();
  if (!written.ok()) {
    first_unwritten_ = now;  // in a while again
    return written;
  }
  begins_anew_ = false;
  pending_.clear();
  first_unwritten_.reset();
  return written;
}

Result<Done> Journal::WriteLines() {
  const Document& document = session_->document();
  const std::string lines = pending_ + DigestLine(WriteProject(document.project()));
  if (!begins_anew_) return file_->Append(lines);
  Result<Done> made = MakeFolder(folder_);
  if (!made.ok()) return made;
  const std::string head =
      JournalHead({Absolute(document.path()), document.file_digest()}, base_, base_state_);
  Result<LockedFile> file =
      LockedFile::Create(file_ ? file_->path() : NewFile(folder_), head + lines);
  if (!file.ok()) return file.error();
  file_ = std::move(file).value();
  return Done();
}

Result<Done> Journal::Discard() {
  observer_.reset();
  first_unwritten_.reset();
  first_change_.reset();
  if (!file_) return Done();
  Result<Done> removed = file_->Remove();
  file_.reset();
  return removed;
}

}  // namespace hazumi::edit
