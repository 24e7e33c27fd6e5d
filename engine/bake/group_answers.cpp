// Two logs: a known one, which is followed call by call as long as the requests are the same bits,
// and from the first other request on one's own, which begins with what was followed so far.

#include "engine/bake/group_answers.h"

#include <utility>

#include "engine/bake/group_run.h"

namespace hazumi {

GroupAnswers::GroupAnswers(std::shared_ptr<const GroupTask> task, MovingBaseCache* moving_bases)
    : task_(std::move(task)), moving_bases_(moving_bases) {}
GroupAnswers::GroupAnswers(GroupAnswers&&) noexcept = default;
GroupAnswers& GroupAnswers::operator=(GroupAnswers&&) noexcept = default;
GroupAnswers::~GroupAnswers() = default;

void GroupAnswers::Begin(BeginGroup request, const KnownLogs* known) {
  keeps_log_ = known != nullptr;
  if (keeps_log_) known_ = known->Find(request);
  Tell(std::move(request));
}

bool GroupAnswers::IsKnown(const GroupRequest& request) const {
  return !own_ && known_ && num_calls_ < known_->size() &&
         SameBits((*known_)[num_calls_].request, request);
}

// Adds a request to the log. From the first one on that is not known the known log is of no use.
void GroupAnswers::Tell(GroupRequest request) {
  if (!IsKnown(request)) {
    if (!own_) own_ = std::make_shared<GroupLog>();
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

const GroupResult& GroupAnswers::Ask(GroupRequest request) {
  Tell(std::move(request));
  if (own_) DoWhatWasAsked();
  const GroupCall& call = own_ ? own_->back() : (*known_)[num_calls_ - 1];
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  return call.result;
}

void GroupAnswers::DoWhatWasAsked() {
  if (!run_) run_ = std::make_unique<GroupRun>(*task_, moving_bases_);
  for (; num_done_ < own_->size(); ++num_done_) {
    GroupCall& call = (*own_)[num_done_];
    call.result = run_->Do(call.request, cancel_);
    call.evaluations = run_->evaluations();
    call.steps = run_->steps();
  }
}

}  // namespace hazumi
