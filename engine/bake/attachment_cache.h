#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "engine/base/same_bits.h"
#include "engine/passive/attachment.h"

namespace hazumi {

// The latest fits of attachments: groups that hang on one node, and solutions of one group, share
// them. Any thread may ask.
class AttachmentCache {
 public:
  // `key`: all that the fit depends on. `fit`: makes it if it is not there.
  template <typename Fit>
  std::shared_ptr<const Attachment> Get(std::vector<double> key, Fit&& fit) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
      if (SameBits(entry.key, key)) return entry.attachment;
    }
    if (entries_.size() == kMost) entries_.erase(entries_.begin());
    entries_.push_back({std::move(key), fit()});
    return entries_.back().attachment;
  }

 private:
  static constexpr size_t kMost = 8;
  struct Entry {
    std::vector<double> key;
    std::shared_ptr<const Attachment> attachment;
  };
  std::mutex mutex_;
  std::vector<Entry> entries_;  // the oldest first
};

}  // namespace hazumi
