#include "engine/bake/group_solution.h"

#include <algorithm>
#include <utility>

#include "engine/bake/group_curves.h"

namespace hazumi {

GroupSolution::GroupSolution(GroupTask task, MovingBaseCache* moving_bases)
    : task_(std::make_shared<const GroupTask>(std::move(task))),
      layout_(task_->model, /*balls=*/true),
      moving_bases_(moving_bases) {}

bool GroupSolution::IsKnown(const GroupRequest& request) const {
  return !own_ && known_ && num_calls_ < known_->size() &&
         SameBits((*known_)[num_calls_].request, request);
}

// Adds a request to the log. From the first one on that is not known the known log is of no use.
void GroupSolution::Tell(GroupRequest request) {
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

const GroupResult& GroupSolution::Ask(GroupRequest request) {
  Tell(std::move(request));
  if (own_) DoWhatWasAsked();
  const GroupCall& call = own_ ? own_->back() : (*known_)[num_calls_ - 1];
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  return call.result;
}

void GroupSolution::DoWhatWasAsked() {
  if (!run_) run_ = std::make_unique<GroupRun>(*task_, moving_bases_);
  for (; num_done_ < own_->size(); ++num_done_) {
    GroupCall& call = (*own_)[num_done_];
    call.result = run_->Do(call.request, cancel_);
    call.evaluations = run_->evaluations();
    call.steps = run_->steps();
  }
}

void GroupSolution::Begin(double t, double end, const RotationState& state,
                          const DrivenMotion& driven, const KnownLogs* known) {
  const auto k = static_cast<Eigen::Index>(hinges().size());
  BeginGroup request = {t, end, VecX(k), VecX(k), CurvesOf(task_->model, driven), task_};
  for (Eigen::Index i = 0; i < k; ++i) {
    request.q[i] = state.q[hinges()[i].coordinate];
    request.qd[i] = state.qd[hinges()[i].coordinate];
  }
  keeps_log_ = known != nullptr;
  if (keeps_log_) known_ = known->Find(request);
  Tell(std::move(request));
  time_ = step_start_ = t;
}

void GroupSolution::Drive(double t, double end, const DrivenMotion& driven) {
  times_.clear();
  Tell(DriveGroup{t, end, CurvesOf(task_->model, driven)});
}

void GroupSolution::FeelPin(const Vec3& v_pin) { Tell(StopPin{v_pin}); }

void GroupSolution::Advance(double t, double end) {
  if (time_ > t || time_ >= end) return;
  times_.clear();
  TakeProgress(Ask(AdvanceGroup{t, end}).progress);
}

bool GroupSolution::LookAhead(const std::vector<double>& times, double end) {
  times_ = times;
  ahead_ = {end, times};
  if (!IsKnown(ahead_)) return false;
  TakeAhead(Ask(std::move(ahead_)));
  return true;
}

void GroupSolution::SolveAhead(const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  TakeAhead(Ask(std::move(ahead_)));
}

void GroupSolution::TakeProgress(const GroupProgress& progress) {
  time_ = progress.time;
  step_start_ = progress.step_start;
  microseconds_ += progress.microseconds;
  hits_.insert(hits_.end(), progress.hits.begin(), progress.hits.end());
  if (progress.failure) failure_ = progress.failure;
}

void GroupSolution::TakeAhead(const GroupResult& result) {
  TakeProgress(result.progress);
  samples_ = result.samples;
}

void GroupSolution::Sample(double t, RotationState* state) {
  const auto ahead = std::lower_bound(times_.begin(), times_.end(), t);
  const size_t size = 2 * hinges().size();
  const size_t at = size * static_cast<size_t>(ahead - times_.begin());
  const bool is_there = ahead != times_.end() && *ahead == t && at + size <= samples_.size();
  Scatter(is_there ? samples_.data() + at : Ask(SampleGroup{t}).samples.data(), state);
}

void GroupSolution::Scatter(const double* sample, RotationState* state) const {
  const int k = layout_.num_hinges();
  for (int i = 0; i < k; ++i) {
    state->q[hinges()[i].coordinate] = sample[i];
    state->qd[hinges()[i].coordinate] = sample[k + i];
  }
}

VecX GroupSolution::Distances(const RotationState& a, const RotationState& b) const {
  const int k = layout_.num_hinges();
  VecX q(k), other(k), distances(k);
  for (int i = 0; i < k; ++i) {
    q[i] = a.q[hinges()[i].coordinate];
    other[i] = b.q[hinges()[i].coordinate];
  }
  layout_.Distances(q, other, &distances);
  return distances;
}

EnergyFlow GroupSolution::Energy(double t) { return Ask(MeasureGroup{t}).energy; }

}  // namespace hazumi
