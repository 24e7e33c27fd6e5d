#pragma once

#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/bake/group_numbers.h"
#include "engine/base/same_bits.h"

namespace hazumi {

// What a solution was asked and what it answered.
struct GroupAnswer {
  Numbers question, answer;
  long evaluations = 0, steps = 0;  // up to the answer
};
// From the beginning on. The answers depend on nothing but the questions.
using GroupLog = std::vector<GroupAnswer>;
using GroupLogs = std::vector<std::shared_ptr<const GroupLog>>;

// Logs of earlier bakes, found by their first question.
class KnownLogs {
 public:
  void Add(const GroupLogs& logs) {
    for (const auto& log : logs) Add(log);
  }
  void clear() { logs_.clear(); }

  // The latest that begins with the question; null if there is none.
  std::shared_ptr<const GroupLog> Find(const Numbers& question) const {
    const auto [begin, end] = logs_.equal_range(HashOf(question));
    for (auto it = begin; it != end; ++it) {
      if (SameBits(it->second->front().question, question)) return it->second;
    }
    return nullptr;
  }

 private:
  void Add(const std::shared_ptr<const GroupLog>& log) {
    const Numbers& question = log->front().question;
    const size_t hash = HashOf(question);
    const auto [begin, end] = logs_.equal_range(hash);
    for (auto it = begin; it != end; ++it) {
      if (!SameBits(it->second->front().question, question)) continue;
      it->second = log;
      return;
    }
    logs_.emplace(hash, log);
  }

  static size_t HashOf(const Numbers& numbers) {
    const auto* bytes = reinterpret_cast<const char*>(numbers.data());
    return std::hash<std::string_view>()({bytes, numbers.size() * sizeof(double)});
  }

  std::unordered_multimap<size_t, std::shared_ptr<const GroupLog>> logs_;
};

}  // namespace hazumi
