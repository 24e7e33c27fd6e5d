#include "engine/bake/group_solution.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace hazumi {

namespace {

// Friction slows motion down by e to the power of this in a step at most: beyond it the estimate of
// a step's error is no estimate.
constexpr double kMostDecay = 2.0;

// What a question begins with.
enum Call { kBegin, kDrive, kFeelPin, kAdvance, kSample, kSampleTwin, kDistances, kEnergy };
// What the answer to kAdvance begins with; hits follow, as times and hinges.
enum AdvanceAnswer { kTime, kStepStart, kTwinTime, kStuckHinge, kCause, kMicroseconds, kHits };

template <typename Derived>
void Append(const Eigen::MatrixBase<Derived>& values, std::vector<double>* numbers) {
  for (const double value : values.reshaped()) numbers->push_back(value);
}

bool SameBits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void Append(const RigidInertia& body, std::vector<double>* numbers) {
  numbers->push_back(body.mass);
  Append(body.com, numbers);
  Append(body.I_com, numbers);
}

}  // namespace

GroupSolution::Run::Run(const GroupTask& task, double step_tolerance)
    : dynamics(task.model, task.friction, task.gravity), solver(&dynamics, task.lower, task.upper) {
  solver.SetTolerance(step_tolerance);
  const double friction = task.friction.size() > 0 ? task.friction.maxCoeff() : 0.0;
  if (friction > 0.0) solver.SetLongestStep(kMostDecay / friction);
}

GroupSolution::Pair::Pair(const GroupTask& task, int num_coordinates)
    : main(task, task.step_tolerance), twin(task, kTwinCoarseness * task.step_tolerance) {
  driven.angles.resize(num_coordinates);
}

GroupSolution::GroupSolution(GroupTask task, int num_coordinates)
    : task_(std::move(task)),
      num_coordinates_(num_coordinates),
      hinges_(RegionLayout(task_.model, false).hinges()) {}

// Everything that the solution depends on but the question's other arguments.
void GroupSolution::AppendTask(Numbers* question) const {
  const RegionModel& model = task_.model;
  Append(model.R_root, question);
  Append(model.p_pin, question);
  for (const double value : {static_cast<double>(model.coupling), double(model.pin_node),
                             double(model.root_answers), model.mass, double(model.nodes.size())}) {
    question->push_back(value);
  }
  for (const ModelNode& node : model.nodes) {
    for (const double value :
         {double(node.parent), static_cast<double>(node.role), double(node.num_hinges),
          double(node.is_ball), double(node.is_dynamic)}) {
      question->push_back(value);
    }
    Append(node.p_P, question);
    Append(node.body, question);
    for (int h = 0; h < node.num_hinges; ++h) {
      question->push_back(node.hinges[h].coordinate);
      Append(node.hinges[h].axis, question);
    }
  }
  for (const VecX* values : {&task_.friction, &task_.lower, &task_.upper}) {
    Append(*values, question);
  }
  question->push_back(task_.gravity);
  question->push_back(task_.step_tolerance);
}

// The curves that the model reads, as a pointer into a DrivenMotion.
template <typename Action>
void GroupSolution::ForEachCurve(Action&& action) const {
  for (const ModelNode& node : task_.model.nodes) {
    if (node.role != Role::kDriven) continue;
    for (int h = 0; h < node.num_hinges; ++h) {
      const Coordinate c = node.hinges[h].coordinate;
      action([c](auto& driven) -> auto& { return driven.angles[c]; });
    }
  }
  if (task_.model.coupling != RootCoupling::kPrescribed) return;
  for (int i = 0; i < 3; ++i) {
    action([i](auto& driven) -> auto& { return driven.root_position[i]; });
  }
}

void GroupSolution::AppendCurves(const DrivenMotion& driven, Numbers* question) const {
  ForEachCurve([&](auto&& of) {
    const DrivenCurve& curve = of(driven);
    question->push_back(curve.start);
    question->push_back(curve.degree);
    question->insert(question->end(), curve.c.begin(), curve.c.begin() + curve.degree + 1);
  });
}

void GroupSolution::ReadCurves(const double* numbers) {
  ForEachCurve([&](auto&& of) {
    DrivenCurve& curve = of(pair_->driven);
    curve = DrivenCurve();
    curve.start = *numbers++;
    curve.degree = static_cast<int>(*numbers++);
    for (int i = 0; i <= curve.degree; ++i) curve.c[i] = *numbers++;
  });
}

const GroupSolution::Numbers& GroupSolution::Ask(Numbers question) {
  const bool is_known = !own_ && known_ && num_calls_ < known_->size() &&
                        SameBits((*known_)[num_calls_].question, question);
  if (!is_known) {
    if (!own_) SolveWhatWasAsked();
    own_->push_back(Execute(std::move(question)));
  }
  const GroupCall& call = is_known ? (*known_)[num_calls_] : own_->back();
  ++num_calls_;
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  return call.answer;
}

// From here on the known log is of no use.
void GroupSolution::SolveWhatWasAsked() {
  own_ = std::make_shared<GroupLog>();
  if (known_) own_->assign(known_->begin(), known_->begin() + static_cast<long>(num_calls_));
  pair_ = std::make_unique<Pair>(task_, num_coordinates_);
  for (const GroupCall& call : *own_) Execute(call.question);
}

GroupCall GroupSolution::Execute(Numbers question) {
  const double* arguments = question.data() + 1;
  GroupCall call;
  switch (static_cast<Call>(static_cast<int>(question[0]))) {
    case kBegin:
      ExecuteBegin(arguments);
      break;
    case kDrive:
      ExecuteDrive(arguments);
      break;
    case kFeelPin:
      for (Run* run : pair_->runs()) {
        run->solver.FeelPin({arguments[0], arguments[1], arguments[2]});
      }
      break;
    case kAdvance:
      call.answer = ExecuteAdvance(arguments[0], arguments[1]);
      break;
    case kSample:
      call.answer = ExecuteSample(&pair_->main, arguments[0]);
      break;
    case kSampleTwin:
      call.answer = ExecuteSample(&pair_->twin, arguments[0]);
      break;
    case kDistances: {
      VecX q, qd, q_twin, qd_twin, distances;
      pair_->main.solver.Sample(arguments[0], &q, &qd);
      pair_->twin.solver.Sample(arguments[0], &q_twin, &qd_twin);
      pair_->main.dynamics.layout().Distances(q, q_twin, &distances);
      Append(distances, &call.answer);
      break;
    }
    case kEnergy: {
      const EnergyFlow flow = pair_->main.solver.Energy(arguments[0]);
      call.answer = {flow.kinetic, flow.potential, flow.friction, flow.keyed};
      break;
    }
  }
  call.question = std::move(question);
  call.evaluations = pair_->main.dynamics.evaluations() + pair_->twin.dynamics.evaluations();
  call.steps = pair_->main.solver.steps();
  return call;
}

void GroupSolution::Begin(double t, double end, const RotationState& state,
                          const RotationState& twin, const DrivenMotion& driven,
                          const GroupLogs& known) {
  Numbers question = {kBegin, t, end};
  for (const VecX* values : {&state.q, &state.qd, &twin.q, &twin.qd}) {
    for (const FreeHinge& hinge : hinges_) question.push_back((*values)[hinge.coordinate]);
  }
  AppendCurves(driven, &question);
  AppendTask(&question);
  for (const std::shared_ptr<const GroupLog>& log : known) {
    if (SameBits(log->front().question, question)) known_ = log;
  }
  Ask(std::move(question));
  time_ = twin_time_ = step_start_ = t;
}

void GroupSolution::ExecuteBegin(const double* arguments) {
  const double t = arguments[0], end = arguments[1];
  const auto k = static_cast<Eigen::Index>(hinges_.size());
  const auto values = [&](int i) { return VecX(Eigen::Map<const VecX>(arguments + 2 + i * k, k)); };
  ReadCurves(arguments + 2 + 4 * k);
  for (Run* run : pair_->runs()) run->dynamics.SetDriven(&pair_->driven, t, end);
  pair_->twin.dynamics.ShareAttachment(pair_->main.dynamics);
  pair_->main.solver.Start(t, values(0), values(1));
  pair_->twin.solver.Start(t, values(2), values(3));
}

void GroupSolution::Drive(double t, double end, const DrivenMotion& driven) {
  Numbers question = {kDrive, t, end};
  AppendCurves(driven, &question);
  Ask(std::move(question));
}

void GroupSolution::ExecuteDrive(const double* arguments) {
  ReadCurves(arguments + 2);
  for (Run* run : pair_->runs()) {
    run->dynamics.SetDriven(&pair_->driven, arguments[0], arguments[1]);
  }
  pair_->twin.dynamics.ShareAttachment(pair_->main.dynamics);
  for (Run* run : pair_->runs()) run->solver.Restart();
}

void GroupSolution::FeelPin(const Vec3& v_pin) { Ask({kFeelPin, v_pin.x(), v_pin.y(), v_pin.z()}); }

std::optional<ExactFailure> GroupSolution::Advance(double t, double end) {
  const auto is_beyond = [&](double time) { return time > t || time >= end; };
  if (is_beyond(time_) && is_beyond(twin_time_)) return std::nullopt;
  const Numbers& answer = Ask({kAdvance, t, end});
  time_ = answer[kTime];
  step_start_ = answer[kStepStart];
  twin_time_ = answer[kTwinTime];
  microseconds_ += answer[kMicroseconds];
  for (size_t i = kHits; i < answer.size(); i += 2) {
    hits_.push_back({answer[i], static_cast<int>(answer[i + 1])});
  }
  if (answer[kStuckHinge] < 0.0) return std::nullopt;
  return ExactFailure{static_cast<int>(answer[kStuckHinge]),
                      static_cast<ExactFailure::Cause>(static_cast<int>(answer[kCause]))};
}

GroupSolution::Numbers GroupSolution::ExecuteAdvance(double t, double end) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<ExactFailure> stuck;
  for (Run* run : pair_->runs()) {
    while (!stuck && run->solver.time() <= t && run->solver.time() < end) {
      stuck = run->solver.Advance(end);
    }
  }
  pair_->twin.solver.TakeHits();
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  Numbers answer(kHits);
  answer[kTime] = pair_->main.solver.time();
  answer[kStepStart] = pair_->main.solver.step_start();
  answer[kTwinTime] = pair_->twin.solver.time();
  answer[kStuckHinge] = stuck ? stuck->hinge : -1.0;
  answer[kCause] = stuck ? static_cast<double>(stuck->cause) : 0.0;
  answer[kMicroseconds] = spent.count();
  for (const StopHit& hit : pair_->main.solver.TakeHits()) {
    answer.push_back(hit.time);
    answer.push_back(hit.hinge);
  }
  return answer;
}

void GroupSolution::Sample(double t, RotationState* state) { Scatter(Ask({kSample, t}), state); }

void GroupSolution::SampleTwin(double t, RotationState* state) {
  Scatter(Ask({kSampleTwin, t}), state);
}

GroupSolution::Numbers GroupSolution::ExecuteSample(Run* run, double t) {
  VecX q, qd;
  run->solver.Sample(t, &q, &qd);
  Numbers answer;
  Append(q, &answer);
  Append(qd, &answer);
  return answer;
}

void GroupSolution::Scatter(const Numbers& answer, RotationState* state) const {
  for (size_t i = 0; i < hinges_.size(); ++i) {
    state->q[hinges_[i].coordinate] = answer[i];
    state->qd[hinges_[i].coordinate] = answer[hinges_.size() + i];
  }
}

VecX GroupSolution::Distances(double t) {
  const Numbers& answer = Ask({kDistances, t});
  return Eigen::Map<const VecX>(answer.data(), static_cast<Eigen::Index>(answer.size()));
}

EnergyFlow GroupSolution::Energy(double t) {
  const Numbers& answer = Ask({kEnergy, t});
  return {answer[0], answer[1], answer[2], answer[3]};
}

}  // namespace hazumi
