#include "engine/bake/group_solution.h"

#include <algorithm>
#include <utility>

namespace hazumi {

namespace {

using P = GroupProgress;

double Numbered(GroupCall call) { return static_cast<double>(call); }

}  // namespace

GroupSolution::GroupSolution(GroupTask task, AttachmentCache* attachments)
    : task_(std::move(task)), layout_(task_.model, /*balls=*/true), attachments_(attachments) {}

bool GroupSolution::IsKnown(const Numbers& question) const {
  return !own_ && known_ && num_calls_ < known_->size() &&
         SameBits((*known_)[num_calls_].question, question);
}

// Adds a question to the log. From the first one on that is not known the known log is of no use.
void GroupSolution::Tell(Numbers question) {
  if (!IsKnown(question)) {
    if (!own_) own_ = std::make_shared<GroupLog>();
    if (!keeps_log_ && num_solved_ == own_->size()) {
      own_->clear();
      num_solved_ = 0;
    }
    if (num_calls_ > 0 && own_->empty() && known_) {
      own_->assign(known_->begin(), known_->begin() + static_cast<long>(num_calls_));
    }
    own_->emplace_back().question = std::move(question);
  }
  ++num_calls_;
}

const Numbers& GroupSolution::Ask(Numbers question) {
  Tell(std::move(question));
  if (own_) SolveWhatWasAsked();
  const GroupAnswer& call = own_ ? own_->back() : (*known_)[num_calls_ - 1];
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  return call.answer;
}

void GroupSolution::SolveWhatWasAsked() {
  if (!run_) run_ = std::make_unique<GroupRun>(task_, attachments_);
  for (; num_solved_ < own_->size(); ++num_solved_) {
    GroupAnswer& call = (*own_)[num_solved_];
    call.answer = run_->Answer(call.question, cancel_);
    call.evaluations = run_->evaluations();
    call.steps = run_->steps();
  }
}

void GroupSolution::Begin(double t, double end, const RotationState& state,
                          const DrivenMotion& driven, const KnownLogs* known) {
  constexpr size_t kRoot = 40, kNode = 33, kHinge = 5;  // numbers
  Numbers question;
  question.reserve(kRoot + kNode * task_.model.nodes.size() + kHinge * hinges().size());
  question = {Numbered(GroupCall::kBegin), t, end};
  for (const VecX* values : {&state.q, &state.qd}) {
    for (const FreeHinge& hinge : hinges()) question.push_back((*values)[hinge.coordinate]);
  }
  AppendCurves(task_.model, task_.model.nodes.size(), driven, &question);
  AppendTask(task_, &question);
  keeps_log_ = known != nullptr;
  if (keeps_log_) known_ = known->Find(question);
  Tell(std::move(question));
  time_ = step_start_ = t;
}

void GroupSolution::Drive(double t, double end, const DrivenMotion& driven) {
  Numbers question = {Numbered(GroupCall::kDrive), t, end};
  AppendCurves(task_.model, task_.model.nodes.size(), driven, &question);
  times_.clear();
  Tell(std::move(question));
}

void GroupSolution::FeelPin(const Vec3& v_pin) {
  Tell({Numbered(GroupCall::kFeelPin), v_pin.x(), v_pin.y(), v_pin.z()});
}

void GroupSolution::Advance(double t, double end) {
  if (time_ > t || time_ >= end) return;
  times_.clear();
  TakeProgress(Ask({Numbered(GroupCall::kAdvance), t, end}));
}

bool GroupSolution::LookAhead(const std::vector<double>& times, double end) {
  times_ = times;
  ahead_ = {Numbered(GroupCall::kAhead), end};
  ahead_.insert(ahead_.end(), times.begin(), times.end());
  if (!IsKnown(ahead_)) return false;
  TakeAhead(Ask(std::move(ahead_)));
  return true;
}

void GroupSolution::SolveAhead(const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  TakeAhead(Ask(std::move(ahead_)));
}

void GroupSolution::TakeProgress(const Numbers& answer) {
  time_ = answer[P::kTime];
  step_start_ = answer[P::kStepStart];
  microseconds_ += answer[P::kMicroseconds];
  for (int i = 0; i < static_cast<int>(answer[P::kNumHits]); ++i) {
    const double* hit = answer.data() + P::kHits + P::kHitSize * i;
    hits_.push_back({hit[1], hit[2], static_cast<long>(hit[3]), static_cast<int>(hit[0])});
  }
  if (answer[P::kStuckHinge] < 0.0) return;
  failure_ = {static_cast<int>(answer[P::kStuckHinge]),
              static_cast<ExactFailure::Cause>(static_cast<int>(answer[P::kCause]))};
}

void GroupSolution::TakeAhead(const Numbers& answer) {
  TakeProgress(answer);
  samples_.assign(answer.begin() + P::kHits + P::kHitSize * static_cast<long>(answer[P::kNumHits]),
                  answer.end());
}

void GroupSolution::Sample(double t, RotationState* state) {
  const auto ahead = std::lower_bound(times_.begin(), times_.end(), t);
  const size_t size = 2 * hinges().size();
  const size_t at = size * static_cast<size_t>(ahead - times_.begin());
  const bool is_there = ahead != times_.end() && *ahead == t && at + size <= samples_.size();
  Scatter(is_there ? samples_.data() + at : Ask({Numbered(GroupCall::kSample), t}).data(), state);
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

EnergyFlow GroupSolution::Energy(double t) {
  const Numbers& answer = Ask({Numbered(GroupCall::kEnergy), t});
  return {answer[0], answer[1], answer[2], answer[3]};
}

}  // namespace hazumi
