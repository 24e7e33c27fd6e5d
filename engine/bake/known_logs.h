#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <unordered_map>

#include "engine/bake/island_request.h"

namespace hazumi {

// Logs of earlier bakes, found by their first request.
class KnownLogs {
 public:
  void Add(const IslandLogs& logs) {
    for (const auto& log : logs) Add(log);
  }
  void clear() { table_ = std::make_unique<Table>(); }

  // The latest that begins with the request; null if there is none.
  std::shared_ptr<const IslandLog> Find(const BeginIsland& request) const {
    const auto [begin, end] = table_->logs.equal_range(HashOf(request));
    for (auto it = begin; it != end; ++it) {
      if (SameBits(FirstOf(*it->second), request)) return it->second;
    }
    return nullptr;
  }

 private:
  // There may be as many logs as joints, and they go all at once.
  struct Table {
    std::pmr::monotonic_buffer_resource memory;
    std::pmr::unordered_multimap<uint64_t, std::shared_ptr<const IslandLog>> logs{&memory};
  };

  // Of what is seldom the same for two requests, which is less than all of it.
  static uint64_t HashOf(const BeginIsland& request) {
    uint64_t sum = request.task ? request.task->model.nodes.back().hinges[0].coordinate : 0;
    const auto add = [&sum](double number) {
      sum = (sum ^ std::bit_cast<uint64_t>(number)) * 0x9e3779b97f4a7c15;
      sum ^= sum >> 32;
    };
    add(request.t);
    add(request.step_tolerance);
    for (const double q : request.state.q) add(q);
    for (const double qd : request.state.qd) add(qd);
    return sum;
  }
  static const BeginIsland& FirstOf(const IslandLog& log) {
    return std::get<BeginIsland>(log.front().request);
  }

  void Add(const std::shared_ptr<const IslandLog>& log) {
    const uint64_t hash = HashOf(FirstOf(*log));
    const auto [begin, end] = table_->logs.equal_range(hash);
    for (auto it = begin; it != end; ++it) {
      if (!SameBits(FirstOf(*it->second), FirstOf(*log))) continue;
      it->second = log;
      return;
    }
    table_->logs.emplace(hash, log);
  }

  std::unique_ptr<Table> table_ = std::make_unique<Table>();
};

}  // namespace hazumi
