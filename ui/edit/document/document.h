#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "engine/project/edits/key_selection.h"
#include "engine/project/project.h"
#include "ui/edit/document/change.h"

namespace hazumi::edit {

// A project that is being edited, with its past and its future. It is changed by transactions only,
// each of which is one undo step.
class Document {
 public:
  explicit Document(Project project, std::string path = "");

  const Project& project() const { return state_.project; }
  // File it was read from or saved to; empty if there is none.
  const std::string& path() const { return path_; }
  // Counts up whenever the project changes, also by undo and redo.
  long revision() const { return revision_; }

  // Keys that are selected. Those that vanish fall out. Undoing or redoing a step that changed the
  // selection, as moving keys does, brings back what was selected there.
  const KeySelection& selected_keys() const { return state_.keys; }
  // Of `keys`, those that there are.
  void set_selected_keys(KeySelection keys);

  // What the next undo and redo would do; none if there is nothing.
  std::optional<std::string> undo_label() const;
  std::optional<std::string> redo_label() const;
  // Of all that can be undone and redone, the next one first.
  std::vector<std::string> undo_labels() const;
  std::vector<std::string> redo_labels() const;
  bool Undo();
  bool Redo();
  // Steps that can be undone or redone, and the memory that they hold, about [bytes].
  size_t num_steps() const { return steps_.size(); }
  size_t history_bytes() const { return bytes_; }
  // The oldest steps are forgotten beyond this. The newest one stays, however large.
  void set_history_limit(size_t bytes);
  size_t history_limit() const { return limit_; }

  // From now on a step is one of its own, whatever it is called: the drag is over.
  void EndMerge();
  // Takes back the drag that is on, as if it had never begun. False if there is none.
  bool CancelMerge();
  // The document when the drag `merge` began, for edits that count from there; null unless the last
  // step was of that drag.
  struct State {
    Project project;
    KeySelection keys;
    int next_id = 1;  // of an item of the project
  };
  const State* drag_start(const std::string& merge) const {
    return !merge.empty() && merge == merge_ ? &merge_before_ : nullptr;
  }
  // The next edit may still become one with the last step.
  bool is_merging() const { return !merge_.empty(); }

  // It is as it was read or saved.
  bool is_saved() const { return saved_ == position_; }
  void MarkSaved(const std::string& path);
  // What the file held when it was read or saved, as DigestOf; empty: not known.
  const std::string& file_digest() const { return file_digest_; }
  void set_file_digest(std::string digest) { file_digest_ = std::move(digest); }
  // Another program has written its file since.
  bool is_changed_elsewhere() const;
  // It is as no file is, whatever is undone.
  void MarkUnsaved() { saved_.reset(); }

  // A journal replays from here on.
  void MarkBase();
  // A step from before the mark has been undone, or one that had been undone before it done again:
  // what replays from the mark does not know it.
  bool has_left_base() const { return has_left_base_; }

 private:
  friend class Transaction;
  struct KeyChange {
    KeySelection before, after;
  };
  struct Step {
    std::string label;
    Change change;
    std::optional<KeyChange> keys;  // if what is selected changed

    size_t bytes() const {
      return change.bytes() + (keys ? BytesOf(keys->before) + BytesOf(keys->after) : 0);
    }
  };

  void Add(const std::string& label, const std::string& merge, const State& before);
  void Forget();

  State state_;
  std::string path_, file_digest_;
  long revision_ = 0;
  std::deque<Step> steps_;
  long forgotten_ = 0;             // steps before steps_[0]
  long position_ = 0;              // steps behind us, forgotten ones too
  std::optional<long> saved_ = 0;  // position; none: it can no longer be reached
  size_t bytes_ = 0, limit_ = size_t{256} << 20;
  long base_ = 0, base_last_ = 0;  // position at the mark, and up to where steps after it lead
  bool has_left_base_ = false;
  std::string merge_;   // of the last step; empty: nothing merges with it
  State merge_before_;  // that step's beginning
};

// Edits a document: change project(), then commit. What is not committed is undone.
class Transaction {
 public:
  explicit Transaction(Document* document) : document_(document), before_(document->state_) {}
  ~Transaction() {
    if (!is_committed_) document_->state_ = std::move(before_);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  Project& project() { return document_->state_.project; }
  const Project& before() const { return before_.project; }
  // Steps in a row with the same `merge`, if not empty, become one: a drag. Nothing changed: no
  // step.
  void Commit(const std::string& label, const std::string& merge = "") {
    is_committed_ = true;
    document_->Add(label, merge, before_);
  }

 private:
  Document* document_;
  Document::State before_;
  bool is_committed_ = false;
};

// Gives an id to each item of the project's lists that has none, or has that of one before it, as a
// copy of an item has. Ids are given in order, from `next` on, which moves on.
void GiveIds(Project* project, int* next);

// Digest of a text: FNV-1a, 64 bits, in hexadecimal.
std::string DigestOf(std::string_view text);
// Digest of what a project's file holds; empty if it cannot be read.
std::string DigestOfFile(const std::string& path);

}  // namespace hazumi::edit
