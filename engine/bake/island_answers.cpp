// Two logs: a known one, which is followed call by call as long as the requests are the same bits,
// and from the first other request on one's own, which begins with what was followed so far.

#include "engine/bake/island_answers.h"

#include <utility>

#include "engine/bake/island_run.h"

namespace hazumi {

IslandAnswers::IslandAnswers(std::shared_ptr<const IslandTask> task, MovingBaseCache* moving_bases)
    : task_(std::move(task)), moving_bases_(moving_bases) {}
IslandAnswers::IslandAnswers(IslandAnswers&&) noexcept = default;
IslandAnswers& IslandAnswers::operator=(IslandAnswers&&) noexcept = default;
IslandAnswers::~IslandAnswers() = default;

void IslandAnswers::Begin(BeginIsland request, const KnownLogs* known) {
  keeps_log_ = known != nullptr;
  if (keeps_log_) known_ = known->Find(request);
  Tell(std::move(request));
}

bool IslandAnswers::IsKnown(const IslandRequest& request) const {
  return !own_ && known_ && num_calls_ < known_->size() &&
         SameBits((*known_)[num_calls_].request, request);
}

// Adds a request to the log. From the first one on that is not known the known log is of no use.
void IslandAnswers::Tell(IslandRequest request) {
  if (!IsKnown(request)) {
    if (!own_) own_ = std::make_shared<IslandLog>();
    if (!keeps_log_ && num_done_ == own_->size()) {
      own_->clear();
      num_done_ = 0;
    }
    if (num_calls_ > 0 && own_->empty() && known_) {
      own_->assign(known_->begin(), known_->begin() + static_cast<long>(num_calls_));
    }
    own_->emplace_back().request = std::move(request);
  }
  ++num_calls_;
}

const IslandResult& IslandAnswers::ResultOf(IslandRequest request) {
  Tell(std::move(request));
  if (own_) DoWhatWasAsked();
  const IslandCall& call = own_ ? own_->back() : (*known_)[num_calls_ - 1];
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  work_ = call.work;
  return call.result;
}

void IslandAnswers::DoWhatWasAsked() {
  if (!run_) run_ = std::make_unique<IslandRun>(*task_, moving_bases_);
  for (; num_done_ < own_->size(); ++num_done_) {
    IslandCall& call = (*own_)[num_done_];
    call.result = run_->Do(call.request, cancel_);
    call.evaluations = run_->evaluations();
    call.steps = run_->steps();
    call.work = run_->work();
  }
}

}  // namespace hazumi
