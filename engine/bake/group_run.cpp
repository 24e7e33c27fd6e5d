#include "engine/bake/group_run.h"

#include <algorithm>
#include <utility>

namespace hazumi {

namespace {

// Friction slows motion down by e to the power of this in a step at most: beyond it the estimate of
// a step's error is no estimate.
constexpr double kMostDecay = 2.0;

// The curves that a group reads are numbered anew: there may be as many groups as joints.
RegionModel WithOwnCurves(RegionModel model, size_t* num_curves) {
  *num_curves = 0;
  for (ModelNode& node : model.nodes) {
    if (node.role != Role::kDriven) continue;
    for (int h = 0; h < node.num_hinges; ++h) {
      node.hinges[h].coordinate = static_cast<Coordinate>((*num_curves)++);
    }
  }
  return model;
}

}  // namespace

GroupRun::GroupRun(const GroupTask& task, AttachmentCache* attachments)
    : gravity_(task.gravity),
      attachments_(attachments),
      dynamics_(WithOwnCurves(task.model, &num_curves_), task.friction, task.gravity),
      solver_(&dynamics_, task.lower, task.upper) {
  driven_.angles.resize(num_curves_);
  solver_.SetTolerance(task.step_tolerance);
  const double friction = task.friction.size() > 0 ? task.friction.maxCoeff() : 0.0;
  if (friction > 0.0) solver_.SetLongestStep(kMostDecay / friction);
}

Numbers GroupRun::Answer(const Numbers& question, const std::atomic<bool>* cancel) {
  const double* arguments = question.data() + 1;
  switch (static_cast<GroupCall>(static_cast<int>(question[0]))) {
    case GroupCall::kBegin:
      Begin(arguments);
      return {};
    case GroupCall::kDrive:
      Drive(arguments);
      return {};
    case GroupCall::kFeelPin:
      solver_.FeelPin({arguments[0], arguments[1], arguments[2]});
      return {};
    case GroupCall::kAdvance:
      return Advance(arguments[0], arguments[1]);
    case GroupCall::kAhead:
      return AdvanceAhead(question, cancel);
    case GroupCall::kSample:
      return Sample(arguments[0]);
    case GroupCall::kEnergy:
      break;
  }
  const EnergyFlow flow = solver_.Energy(arguments[0]);
  return {flow.kinetic, flow.potential, flow.friction, flow.keyed};
}

void GroupRun::Begin(const double* arguments) {
  const double t = arguments[0], end = arguments[1];
  const auto k = static_cast<Eigen::Index>(dynamics_.num_hinges());
  const auto values = [&](int i) { return VecX(Eigen::Map<const VecX>(arguments + 2 + i * k, k)); };
  ReadCurves(dynamics_.model(), arguments + 2 + 2 * k, &driven_);
  Attach(t, end);
  solver_.Start(t, values(0), values(1));
}

void GroupRun::Drive(const double* arguments) {
  ReadCurves(dynamics_.model(), arguments + 2, &driven_);
  Attach(arguments[0], arguments[1]);
  solver_.Restart();
}

// The model is driven by the curves that were read, which are smooth from t to `end`.
void GroupRun::Attach(double t, double end) {
  dynamics_.SetCurves(&driven_, t);
  if (!dynamics_.needs_attachment()) return;
  Numbers key =
      AttachmentKey(dynamics_.model(), dynamics_.first_moved(), gravity_, driven_, t, end);
  dynamics_.UseAttachment(
      attachments_->Get(std::move(key), [&] { return dynamics_.FitAttachment(t, end); }));
}

Numbers GroupRun::Advance(double t, double end) {
  const Instant since = std::chrono::steady_clock::now();
  std::optional<ExactFailure> stuck;
  while (!stuck && solver_.time() <= t && solver_.time() < end) stuck = solver_.Advance(end);
  return Progress(since, stuck);
}

// What is at a time is that of the step which ends there, if one does.
Numbers GroupRun::AdvanceAhead(const Numbers& question, const std::atomic<bool>* cancel) {
  const Instant since = std::chrono::steady_clock::now();
  const auto is_cancelled = [&] { return cancel && cancel->load(std::memory_order_relaxed); };
  const double end = question[1];
  std::optional<ExactFailure> stuck;
  Numbers samples;
  for (auto t = question.begin() + 2; t != question.end(); ++t) {
    while (!stuck && solver_.time() < std::min(*t, end) && !is_cancelled()) {
      stuck = solver_.Advance(end);
    }
    if (stuck || is_cancelled()) break;
    const Numbers sample = Sample(*t);
    samples.insert(samples.end(), sample.begin(), sample.end());
  }
  Numbers answer = Progress(since, stuck);
  answer.insert(answer.end(), samples.begin(), samples.end());
  return answer;
}

Numbers GroupRun::Progress(Instant since, const std::optional<ExactFailure>& stuck) {
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - since;
  const std::vector<StopHit> hits = solver_.TakeHits();
  using P = GroupProgress;
  Numbers answer(P::kHits);
  answer[P::kTime] = solver_.time();
  answer[P::kStepStart] = solver_.step_start();
  answer[P::kStuckHinge] = stuck ? stuck->hinge : -1.0;
  answer[P::kCause] = stuck ? static_cast<double>(stuck->cause) : 0.0;
  answer[P::kMicroseconds] = spent.count();
  answer[P::kNumHits] = static_cast<double>(hits.size());
  for (const StopHit& hit : hits) {
    answer.insert(answer.end(), {static_cast<double>(hit.hinge), hit.time, hit.last_time,
                                 static_cast<double>(hit.count)});
  }
  return answer;
}

Numbers GroupRun::Sample(double t) {
  VecX q, qd;
  solver_.Sample(t, &q, &qd);
  Numbers sample;
  Append(q, &sample);
  Append(qd, &sample);
  return sample;
}

}  // namespace hazumi
