#include "engine/bake/group_solution.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace hazumi {

namespace {

// Friction slows motion down by e to the power of this in a step at most: beyond it the estimate of
// a step's error is no estimate.
constexpr double kMostDecay = 2.0;

// What a question begins with.
enum Call { kBegin, kDrive, kFeelPin, kAdvance, kAhead, kSample, kEnergy };
// What the answers to kAdvance and kAhead begin with; as many hits follow, as times and hinges, and
// for kAhead what is at the times.
enum Progress { kTime, kStepStart, kStuckHinge, kCause, kMicroseconds, kNumHits, kHits };

template <typename Derived>
void Append(const Eigen::MatrixBase<Derived>& values, std::vector<double>* numbers) {
  for (const double value : values.reshaped()) numbers->push_back(value);
}

void Append(const RigidInertia& body, std::vector<double>* numbers) {
  numbers->push_back(body.mass);
  Append(body.com, numbers);
  Append(body.I_com, numbers);
}

void Append(const ModelNode& node, std::vector<double>* numbers) {
  for (const double value :
       {double(node.parent), static_cast<double>(node.role), double(node.num_hinges),
        double(node.is_ball), double(node.is_dynamic)}) {
    numbers->push_back(value);
  }
  Append(node.p_P, numbers);
  Append(node.body, numbers);
  for (int h = 0; h < node.num_hinges; ++h) {
    numbers->push_back(node.hinges[h].coordinate);
    Append(node.hinges[h].axis, numbers);
  }
}

// All of the model but its nodes and mass.
void AppendRoot(const RegionModel& model, std::vector<double>* numbers) {
  Append(model.R_root, numbers);
  Append(model.p_pin, numbers);
  for (const double value :
       {static_cast<double>(model.coupling), double(model.pin_node), double(model.root_answers)}) {
    numbers->push_back(value);
  }
}

}  // namespace

GroupSolution::Run::Run(const GroupTask& task, int num_coordinates)
    : dynamics(task.model, task.friction, task.gravity), solver(&dynamics, task.lower, task.upper) {
  driven.angles.resize(num_coordinates);
  solver.SetTolerance(task.step_tolerance);
  const double friction = task.friction.size() > 0 ? task.friction.maxCoeff() : 0.0;
  if (friction > 0.0) solver.SetLongestStep(kMostDecay / friction);
}

GroupSolution::GroupSolution(GroupTask task, int num_coordinates, AttachmentCache* attachments)
    : task_(std::move(task)),
      num_coordinates_(num_coordinates),
      layout_(task_.model, /*balls=*/true),
      attachments_(attachments) {}

// Everything that the solution depends on but the question's other arguments.
void GroupSolution::AppendTask(Numbers* question) const {
  AppendRoot(task_.model, question);
  question->push_back(task_.model.mass);
  question->push_back(num_nodes());
  for (const ModelNode& node : task_.model.nodes) Append(node, question);
  for (const VecX* values : {&task_.friction, &task_.lower, &task_.upper}) {
    Append(*values, question);
  }
  question->push_back(task_.gravity);
  question->push_back(task_.step_tolerance);
}

// The curves that the first nodes of the model read, as a pointer into a DrivenMotion.
template <typename Action>
void GroupSolution::ForEachCurve(int num_nodes, Action&& action) const {
  for (int i = 0; i < num_nodes; ++i) {
    const ModelNode& node = task_.model.nodes[i];
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

void GroupSolution::AppendCurves(const DrivenMotion& driven, int num_nodes,
                                 Numbers* question) const {
  ForEachCurve(num_nodes, [&](auto&& of) {
    const DrivenCurve& curve = of(driven);
    question->push_back(curve.start);
    question->push_back(curve.degree);
    question->insert(question->end(), curve.c.begin(), curve.c.begin() + curve.degree + 1);
  });
}

void GroupSolution::ReadCurves(const double* numbers) {
  ForEachCurve(num_nodes(), [&](auto&& of) {
    DrivenCurve& curve = of(run_->driven);
    curve = DrivenCurve();
    curve.start = *numbers++;
    curve.degree = static_cast<int>(*numbers++);
    for (int i = 0; i <= curve.degree; ++i) curve.c[i] = *numbers++;
  });
}

bool GroupSolution::IsKnown(const Numbers& question) const {
  return !own_ && known_ && num_calls_ < known_->size() &&
         SameBits((*known_)[num_calls_].question, question);
}

// Adds a question to the log. From the first one on that is not known the known log is of no use.
void GroupSolution::Tell(Numbers question) {
  if (!IsKnown(question)) {
    if (!own_) own_ = std::make_shared<GroupLog>();
    if (num_calls_ > 0 && own_->empty()) {
      own_->assign(known_->begin(), known_->begin() + static_cast<long>(num_calls_));
    }
    own_->emplace_back().question = std::move(question);
  }
  ++num_calls_;
}

const GroupSolution::Numbers& GroupSolution::Ask(Numbers question) {
  Tell(std::move(question));
  if (own_) SolveWhatWasAsked();
  const GroupCall& call = own_ ? own_->back() : (*known_)[num_calls_ - 1];
  evaluations_ = call.evaluations;
  steps_ = call.steps;
  return call.answer;
}

void GroupSolution::SolveWhatWasAsked() {
  if (!run_) run_ = std::make_unique<Run>(task_, num_coordinates_);
  for (; num_solved_ < own_->size(); ++num_solved_) Execute(&(*own_)[num_solved_]);
}

void GroupSolution::Execute(GroupCall* call) {
  const double* arguments = call->question.data() + 1;
  switch (static_cast<Call>(static_cast<int>(call->question[0]))) {
    case kBegin:
      ExecuteBegin(arguments);
      break;
    case kDrive:
      ExecuteDrive(arguments);
      break;
    case kFeelPin:
      run_->solver.FeelPin({arguments[0], arguments[1], arguments[2]});
      break;
    case kAdvance:
      call->answer = ExecuteAdvance(arguments[0], arguments[1]);
      break;
    case kAhead:
      call->answer = ExecuteAhead(call->question);
      break;
    case kSample:
      call->answer = ExecuteSample(arguments[0]);
      break;
    case kEnergy: {
      const EnergyFlow flow = run_->solver.Energy(arguments[0]);
      call->answer = {flow.kinetic, flow.potential, flow.friction, flow.keyed};
      break;
    }
  }
  call->evaluations = run_->dynamics.evaluations();
  call->steps = run_->solver.steps();
}

void GroupSolution::Begin(double t, double end, const RotationState& state,
                          const DrivenMotion& driven, const GroupLogs& known) {
  constexpr size_t kUsual = 1000;  // numbers
  Numbers question;
  question.reserve(kUsual);
  question = {kBegin, t, end};
  for (const VecX* values : {&state.q, &state.qd}) {
    for (const FreeHinge& hinge : hinges()) question.push_back((*values)[hinge.coordinate]);
  }
  AppendCurves(driven, num_nodes(), &question);
  AppendTask(&question);
  for (const std::shared_ptr<const GroupLog>& log : known) {
    if (SameBits(log->front().question, question)) known_ = log;
  }
  Tell(std::move(question));
  time_ = step_start_ = t;
}

void GroupSolution::ExecuteBegin(const double* arguments) {
  const double t = arguments[0], end = arguments[1];
  const auto k = static_cast<Eigen::Index>(hinges().size());
  const auto values = [&](int i) { return VecX(Eigen::Map<const VecX>(arguments + 2 + i * k, k)); };
  ReadCurves(arguments + 2 + 2 * k);
  Attach(t, end);
  run_->solver.Start(t, values(0), values(1));
}

// Drives the model by the curves that were read, which are smooth from t to `end`.
void GroupSolution::Attach(double t, double end) {
  RegionDynamics& dynamics = run_->dynamics;
  dynamics.SetCurves(&run_->driven, t);
  if (!dynamics.needs_attachment()) return;
  Numbers key = {t, end, task_.gravity};
  AppendRoot(task_.model, &key);
  for (int i = 0; i < dynamics.first_moved(); ++i) Append(task_.model.nodes[i], &key);
  key.push_back(task_.model.nodes[dynamics.first_moved()].parent);
  AppendCurves(run_->driven, dynamics.first_moved(), &key);
  dynamics.UseAttachment(
      attachments_->Get(std::move(key), [&] { return dynamics.FitAttachment(t, end); }));
}

void GroupSolution::Drive(double t, double end, const DrivenMotion& driven) {
  Numbers question = {kDrive, t, end};
  AppendCurves(driven, num_nodes(), &question);
  times_.clear();
  Tell(std::move(question));
}

void GroupSolution::ExecuteDrive(const double* arguments) {
  ReadCurves(arguments + 2);
  Attach(arguments[0], arguments[1]);
  run_->solver.Restart();
}

void GroupSolution::FeelPin(const Vec3& v_pin) {
  Tell({kFeelPin, v_pin.x(), v_pin.y(), v_pin.z()});
}

void GroupSolution::Advance(double t, double end) {
  if (time_ > t || time_ >= end) return;
  times_.clear();
  TakeProgress(Ask({kAdvance, t, end}));
}

GroupSolution::Numbers GroupSolution::ExecuteAdvance(double t, double end) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<ExactFailure> stuck;
  ExactSolver& solver = run_->solver;
  while (!stuck && solver.time() <= t && solver.time() < end) stuck = solver.Advance(end);
  return ProgressFrom(start, stuck);
}

bool GroupSolution::LookAhead(const std::vector<double>& times, double end) {
  times_ = times;
  ahead_ = {kAhead, end};
  ahead_.insert(ahead_.end(), times.begin(), times.end());
  if (!IsKnown(ahead_)) return false;
  TakeAhead(Ask(std::move(ahead_)));
  return true;
}

void GroupSolution::SolveAhead(const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  TakeAhead(Ask(std::move(ahead_)));
}

// What is at a time is that of the step which ends there, if one does.
GroupSolution::Numbers GroupSolution::ExecuteAhead(const Numbers& question) {
  const auto start = std::chrono::steady_clock::now();
  const double end = question[1];
  std::optional<ExactFailure> stuck;
  ExactSolver& solver = run_->solver;
  Numbers samples;
  for (auto t = question.begin() + 2; t != question.end(); ++t) {
    while (!stuck && solver.time() < std::min(*t, end) && !is_cancelled()) {
      stuck = solver.Advance(end);
    }
    if (stuck) break;
    const Numbers sample = ExecuteSample(*t);
    samples.insert(samples.end(), sample.begin(), sample.end());
  }
  Numbers answer = ProgressFrom(start, stuck);
  answer.insert(answer.end(), samples.begin(), samples.end());
  return answer;
}

GroupSolution::Numbers GroupSolution::ProgressFrom(std::chrono::steady_clock::time_point start,
                                                   const std::optional<ExactFailure>& stuck) {
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  const std::vector<StopHit> hits = run_->solver.TakeHits();
  Numbers answer(kHits);
  answer[kTime] = run_->solver.time();
  answer[kStepStart] = run_->solver.step_start();
  answer[kStuckHinge] = stuck ? stuck->hinge : -1.0;
  answer[kCause] = stuck ? static_cast<double>(stuck->cause) : 0.0;
  answer[kMicroseconds] = spent.count();
  answer[kNumHits] = static_cast<double>(hits.size());
  for (const StopHit& hit : hits) {
    answer.push_back(hit.time);
    answer.push_back(hit.hinge);
  }
  return answer;
}

void GroupSolution::TakeProgress(const Numbers& answer) {
  time_ = answer[kTime];
  step_start_ = answer[kStepStart];
  microseconds_ += answer[kMicroseconds];
  for (int i = 0; i < static_cast<int>(answer[kNumHits]); ++i) {
    hits_.push_back({answer[kHits + 2 * i], static_cast<int>(answer[kHits + 2 * i + 1])});
  }
  if (answer[kStuckHinge] < 0.0) return;
  failure_ = {static_cast<int>(answer[kStuckHinge]),
              static_cast<ExactFailure::Cause>(static_cast<int>(answer[kCause]))};
}

void GroupSolution::TakeAhead(const Numbers& answer) {
  TakeProgress(answer);
  samples_.assign(answer.begin() + kHits + 2 * static_cast<long>(answer[kNumHits]), answer.end());
}

GroupSolution::Numbers GroupSolution::ExecuteSample(double t) {
  VecX q, qd;
  run_->solver.Sample(t, &q, &qd);
  Numbers answer;
  Append(q, &answer);
  Append(qd, &answer);
  return answer;
}

void GroupSolution::Sample(double t, RotationState* state) {
  const auto ahead = std::lower_bound(times_.begin(), times_.end(), t);
  const size_t size = 2 * hinges().size();
  const size_t at = size * static_cast<size_t>(ahead - times_.begin());
  const bool is_there = ahead != times_.end() && *ahead == t && at + size <= samples_.size();
  Scatter(is_there ? samples_.data() + at : Ask({kSample, t}).data(), state);
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
  const Numbers& answer = Ask({kEnergy, t});
  return {answer[0], answer[1], answer[2], answer[3]};
}

}  // namespace hazumi
