#pragma once

#include <memory>
#include <unordered_map>

#include "engine/bake/group_request.h"

namespace hazumi {

// Logs of earlier bakes, found by their first request.
class KnownLogs {
 public:
  void Add(const GroupLogs& logs) {
    for (const auto& log : logs) Add(log);
  }
  void clear() { logs_.clear(); }

  // The latest that begins with the request; null if there is none.
  std::shared_ptr<const GroupLog> Find(const BeginGroup& request) const {
    const auto [begin, end] = logs_.equal_range(HashOfBits(request));
    for (auto it = begin; it != end; ++it) {
      if (SameBits(FirstOf(*it->second), request)) return it->second;
    }
    return nullptr;
  }

 private:
  static const BeginGroup& FirstOf(const GroupLog& log) {
    return std::get<BeginGroup>(log.front().request);
  }

  void Add(const std::shared_ptr<const GroupLog>& log) {
    const uint64_t hash = HashOfBits(FirstOf(*log));
    const auto [begin, end] = logs_.equal_range(hash);
    for (auto it = begin; it != end; ++it) {
      if (!SameBits(FirstOf(*it->second), FirstOf(*log))) continue;
      it->second = log;
      return;
    }
    logs_.emplace(hash, log);
  }

  std::unordered_multimap<uint64_t, std::shared_ptr<const GroupLog>> logs_;
};

}  // namespace hazumi
