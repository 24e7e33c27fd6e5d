#include "ui/edit/document.h"

namespace hazumi::edit {

Document::Document(Project project, std::string path)
    : project_(std::move(project)), path_(std::move(path)) {}

std::optional<std::string> Document::undo_label() const {
  if (position_ == forgotten_) return std::nullopt;
  return steps_[position_ - forgotten_ - 1].label;
}

std::optional<std::string> Document::redo_label() const {
  if (position_ - forgotten_ == static_cast<long>(steps_.size())) return std::nullopt;
  return steps_[position_ - forgotten_].label;
}

bool Document::Undo() {
  EndMerge();
  if (!undo_label()) return false;
  --position_;
  has_left_base_ |= position_ < base_;
  steps_[position_ - forgotten_].change.Revert(&project_);
  ++revision_;
  return true;
}

bool Document::Redo() {
  EndMerge();
  if (!redo_label()) return false;
  steps_[position_ - forgotten_].change.Apply(&project_);
  ++position_;
  has_left_base_ |= position_ > base_last_;
  ++revision_;
  return true;
}

void Document::EndMerge() {
  if (!merge_.empty() && steps_.back().change.is_empty()) {  // dragged back to where it was
    bytes_ -= steps_.back().change.bytes();
    steps_.pop_back();
    --position_;
    has_left_base_ |= position_ < base_;
  }
  merge_.clear();
}

void Document::MarkSaved(const std::string& path) {
  EndMerge();
  path_ = path;
  saved_ = position_;
}

void Document::MarkBase() {
  base_ = base_last_ = position_;
  has_left_base_ = false;
}

void Document::set_history_limit(size_t bytes) {
  limit_ = bytes;
  Forget();
}

void Document::Add(const std::string& label, const std::string& merge, const Project& before) {
  if (before == project_) return;
  ++revision_;
  while (redo_label()) {  // another future begins
    bytes_ -= steps_.back().change.bytes();
    steps_.pop_back();
  }
  if (saved_ && *saved_ > position_) saved_.reset();
  const bool merges = !merge.empty() && merge == merge_;
  if (!merges) EndMerge();
  if (merges) {
    bytes_ -= steps_.back().change.bytes();
    steps_.pop_back();
    --position_;
  } else {
    merge_ = merge;
    merge_before_ = merge.empty() ? Project() : before;
  }
  Change change(merges ? merge_before_ : before, project_);
  bytes_ += change.bytes();
  steps_.push_back({label, std::move(change)});
  base_last_ = ++position_;
  Forget();
}

void Document::Forget() {
  while (bytes_ > limit_ && steps_.size() > 1 && position_ > forgotten_ + 1) {
    bytes_ -= steps_.front().change.bytes();
    steps_.pop_front();
    ++forgotten_;
  }
  if (saved_ && *saved_ < forgotten_) saved_.reset();
}

}  // namespace hazumi::edit
