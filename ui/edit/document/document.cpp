#include "ui/edit/document/document.h"

#include <cstdint>
#include <cstdio>

#include "engine/project/json/text_file.h"

namespace hazumi::edit {

Document::Document(Project project, std::string path)
    : state_{std::move(project), {}}, path_(std::move(path)) {
  GiveIds(&state_.project, &state_.next_id);
}

std::optional<std::string> Document::undo_label() const {
  if (position_ == forgotten_) return std::nullopt;
  return steps_[position_ - forgotten_ - 1].label;
}

std::optional<std::string> Document::redo_label() const {
  if (position_ - forgotten_ == static_cast<long>(steps_.size())) return std::nullopt;
  return steps_[position_ - forgotten_].label;
}

std::vector<std::string> Document::undo_labels() const {
  std::vector<std::string> labels;
  for (long i = position_ - forgotten_; i > 0; --i) labels.push_back(steps_[i - 1].label);
  return labels;
}

std::vector<std::string> Document::redo_labels() const {
  std::vector<std::string> labels;
  for (size_t i = position_ - forgotten_; i < steps_.size(); ++i) labels.push_back(steps_[i].label);
  return labels;
}

// A refusal leaves a drag under way, as every refused operator does: journals know nothing of it.
bool Document::Undo() {
  const bool is_back = is_merging() && steps_.back().change.is_empty();
  if (position_ - forgotten_ == (is_back ? 1 : 0)) return false;
  EndMerge();
  --position_;
  has_left_base_ |= position_ < base_;
  const Step& step = steps_[position_ - forgotten_];
  step.change.Revert(&state_.project);
  if (step.keys) state_.keys = step.keys->before;
  DropMissing(state_.project, &state_.keys);
  ++revision_;
  return true;
}

bool Document::Redo() {
  if (!redo_label()) return false;
  EndMerge();
  const Step& step = steps_[position_ - forgotten_];
  step.change.Apply(&state_.project);
  if (step.keys) state_.keys = step.keys->after;
  DropMissing(state_.project, &state_.keys);
  ++position_;
  has_left_base_ |= position_ > base_last_;
  ++revision_;
  return true;
}

void Document::set_selected_keys(KeySelection keys) {
  state_.keys = std::move(keys);
  DropMissing(state_.project, &state_.keys);
}

void Document::EndMerge() {
  if (!merge_.empty() && steps_.back().change.is_empty()) {  // dragged back to where it was
    bytes_ -= steps_.back().bytes();
    steps_.pop_back();
    --position_;
    has_left_base_ |= position_ < base_;
  }
  merge_.clear();
}

bool Document::CancelMerge() {
  if (merge_.empty()) return false;
  merge_.clear();
  --position_;
  steps_.back().change.Revert(&state_.project);
  state_.keys = merge_before_.keys;
  bytes_ -= steps_.back().bytes();
  steps_.pop_back();
  has_left_base_ |= position_ < base_;
  ++revision_;
  return true;
}

void Document::MarkSaved(const std::string& path) {
  EndMerge();
  path_ = path;
  file_digest_ = DigestOfFile(path);
  saved_ = position_;
}

// A file that is gone is not changed: nothing is lost where it is written again.
bool Document::is_changed_elsewhere() const {
  if (path_.empty() || file_digest_.empty()) return false;
  const std::string now = DigestOfFile(path_);
  return !now.empty() && now != file_digest_;
}

void Document::MarkBase() {
  base_ = base_last_ = position_;
  has_left_base_ = false;
}

void Document::set_history_limit(size_t bytes) {
  limit_ = bytes;
  Forget();
}

void Document::Add(const std::string& label, const std::string& merge, const State& before) {
  DropMissing(state_.project, &state_.keys);
  if (before.project == state_.project) return;
  ++revision_;
  while (redo_label()) {  // another future begins
    bytes_ -= steps_.back().bytes();
    steps_.pop_back();
  }
  if (saved_ && *saved_ > position_) saved_.reset();
  const bool merges = !merge.empty() && merge == merge_;
  if (!merges) EndMerge();
  if (merges) {
    bytes_ -= steps_.back().bytes();
    steps_.pop_back();
    --position_;
  } else {
    merge_ = merge;
    merge_before_ = merge.empty() ? State() : before;
  }
  const State& from = merges ? merge_before_ : before;
  // What a drag makes is the same item at each of its steps.
  state_.next_id = from.next_id;
  GiveIds(&state_.project, &state_.next_id);
  Step step{label, Change(from.project, state_.project), std::nullopt};
  if (from.keys != state_.keys) step.keys = {from.keys, state_.keys};
  bytes_ += step.bytes();
  steps_.push_back(std::move(step));
  base_last_ = ++position_;
  Forget();
}

void Document::Forget() {
  while (bytes_ > limit_ && steps_.size() > 1 && position_ > forgotten_ + 1) {
    bytes_ -= steps_.front().bytes();
    steps_.pop_front();
    ++forgotten_;
  }
  if (saved_ && *saved_ < forgotten_) saved_.reset();
}

std::string DigestOf(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string DigestOfFile(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  return text.ok() ? DigestOf(text.value()) : "";
}

}  // namespace hazumi::edit
