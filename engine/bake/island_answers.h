#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <variant>

#include "engine/bake/island_request.h"
#include "engine/bake/known_logs.h"
#include "engine/bake/moving_base_cache.h"

namespace hazumi {

class IslandRun;

// What an island answers to its requests.
//
// It keeps a log. As long as it is asked what a known log holds it answers from there and solves
// nothing; at the first other request it does all that was asked up to then. A request that gives
// no result (Begin, Drive) waits until one comes that does.
class IslandAnswers {
 public:
  // `moving_bases` must outlive it.
  IslandAnswers(std::shared_ptr<const IslandTask> task, MovingBaseCache* moving_bases);
  IslandAnswers(IslandAnswers&&) noexcept;
  IslandAnswers& operator=(IslandAnswers&&) noexcept;
  ~IslandAnswers();

  // The first request. `known`: logs of earlier bakes; null: it keeps none itself.
  void Begin(BeginIsland request, const KnownLogs* known);
  // One that gives no result.
  void Tell(IslandRequest request);
  // The result stays until the next request.
  template <typename Request>
  const typename Request::Result& Ask(Request request) {
    return std::get<typename Request::Result>(ResultOf(std::move(request)));
  }
  // Whether a known log tells the answer.
  bool IsKnown(const IslandRequest& request) const;
  // It gives up where this is set, from now on.
  void SetCancel(const std::atomic<bool>* cancel) { cancel_ = cancel; }

  // That the results so far took.
  long evaluations() const { return evaluations_; }
  long steps() const { return steps_; }
  const Work& work() const { return work_; }
  std::shared_ptr<const IslandLog> log() const { return own_ ? own_ : known_; }

 private:
  const IslandResult& ResultOf(IslandRequest request);
  void DoWhatWasAsked();

  std::shared_ptr<const IslandTask> task_;
  MovingBaseCache* moving_bases_;
  const std::atomic<bool>* cancel_ = nullptr;
  std::shared_ptr<const IslandLog> known_;  // answers as long as own_ is null
  std::shared_ptr<IslandLog> own_;
  bool keeps_log_ = true;
  size_t num_calls_ = 0;
  std::unique_ptr<IslandRun> run_;  // null as long as nothing is solved
  size_t num_done_ = 0;             // of own_
  long evaluations_ = 0, steps_ = 0;
  Work work_;
};

}  // namespace hazumi
