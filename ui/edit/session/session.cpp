#include "ui/edit/session/session.h"

#include <algorithm>
#include <cmath>

#include "engine/figure/figure_builder.h"
#include "engine/project/address/all_addresses.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/placements.h"
#include "engine/project/items.h"
#include "engine/project/project_files.h"
#include "ui/edit/new_project.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

Session::Session() { Replace(NewProject(), ""); }

void Session::Replace(Project project, const std::string& path) {
  document_ = std::make_unique<Document>(std::move(project), path);
  KeepFilesOf(document_->project(), path);
  ++document_number_;
  selected_joints_.clear();
  hidden_joints_.clear();
  locked_joints_.clear();
  frame_ = document_->project().frames.first;
  compiled_revision_ = -1;
  const ProjectFigure& source = document_->project().figure;
  if (figure_ && figure_source_ == source) return;
  TakeFigure(std::make_shared<const Figure>(BuildFigure(source.spec).value()));
}

// The same figure as long as the project's does not change: nothing is built anew, and a bake can
// go on.
Result<Compiled> Session::CompileProject(const Project& project) const {
  const bool is_same = figure_ && figure_source_ == project.figure;
  return CompileAnimation(project, nullptr, is_same ? figure_ : nullptr);
}

void Session::TakeFigure(std::shared_ptr<const Figure> figure) {
  figure_ = std::move(figure);
  figure_source_ = document_->project().figure;
}

Result<Done> Session::Edit(const std::string& label,
                           const std::function<Result<Done>(Project*)>& change,
                           const std::string& merge) {
  const bool could_be_animated = animation() != nullptr;
  Transaction transaction(document_.get());
  Result<Done> done = change(&transaction.project());
  if (!done.ok()) return done;
  Result<std::vector<makers::FillReport>> filled =
      Refill(transaction.before(), merge, &transaction.project());
  // Who changes the fills is told; other edits leave them as they are until they can be made.
  const bool changes_fills = transaction.before().fills != transaction.project().fills;
  if (!filled.ok() && changes_fills && could_be_animated) return filled.error();
  Result<Compiled> compiled = CompileProject(transaction.project());
  if (!compiled.ok() && (could_be_animated || compiled.error().code == ErrorCode::kSchema)) {
    return compiled.error();
  }
  transaction.Commit(label, merge);
  Take(std::move(compiled));
  fill_error_ = filled.ok() ? std::nullopt : std::optional(filled.error());
  fill_reports_ = filled.ok() ? std::move(filled).value() : std::vector<makers::FillReport>();
  return done;
}

Result<std::vector<makers::FillReport>> Session::Refill(const Project& before,
                                                        const std::string& merge, Project* after) {
  const Document::State* start = document_->drag_start(merge);
  const bool has_same_figure = after->figure == figure_source_;
  return RenewFills({before, start ? &start->project : nullptr, fill_error_.has_value()},
                    has_same_figure ? figure_ : nullptr, after);
}

std::shared_ptr<const SessionObserver> Session::Observe(SessionObserver observer) {
  std::erase_if(observers_, [](const auto& other) { return other.expired(); });
  auto kept = std::make_shared<const SessionObserver>(std::move(observer));
  observers_.push_back(kept);
  return kept;
}

// Who is told may begin or end to observe.
void Session::Tell(const std::function<void(const SessionObserver&)>& what) const {
  for (const auto& observer : std::vector(observers_)) {
    if (const auto kept = observer.lock()) what(*kept);
  }
}

namespace {

std::set<ItemId> IdsOf(const Project& project) {
  std::set<ItemId> ids;
  ForEachItemList(
      [&](auto, const auto& items) {
        for (const auto& item : items) ids.insert(item.identity.id);
      },
      project);
  return ids;
}

// Returns the addresses of the items that are not among the known ones.
std::vector<std::string> NewItems(const std::set<ItemId>& known, const Project& project) {
  if (IdsOf(project) == known) return {};
  std::vector<std::string> addresses;
  for (const ItemAddress& item : ItemAddresses(project)) {
    if (!known.contains(item.id)) addresses.push_back(item.address);
  }
  return addresses;
}

}  // namespace

Result<Done> Session::Run(const std::string& id, const Json& parameters) {
  if (is_running_) return RunUnobserved(id, parameters);
  Tell([](const SessionObserver& observer) {
    if (observer.before) observer.before();
  });
  is_running_ = true;
  outcome_ = Outcome();
  const std::set<ItemId> before = IdsOf(project());
  const long document = document_number_;
  Result<Done> done = RunUnobserved(id, parameters);
  is_running_ = false;
  if (!done.ok()) return done;
  if (document == document_number_) outcome_.made = NewItems(before, project());
  Tell([&](const SessionObserver& observer) {
    if (observer.after) observer.after(id, parameters);
  });
  return done;
}

Result<Done> Session::RunUnobserved(const std::string& id, const Json& parameters) {
  const Operator* op = FindOperator(id);
  if (!op) return Error{ErrorCode::kSchema, "", id, "there is no such operator"};
  Result<Parameters> checked = Parameters::Check(op->parameters, parameters);
  Result<Done> done = checked.ok() ? op->run(this, checked.value()) : checked.error();
  if (!done.ok()) {
    Error error = done.error();
    // What lies in a file lies there whoever reads it.
    if (error.file.empty()) error.place = error.place.empty() ? id : id + "." + error.place;
    return error;
  }
  // Undo may have brought another figure back: what figure() gives stays as it is until the next.
  Compile();
  return done;
}

void Session::Compile() {
  if (compiled_revision_ == document_->revision()) return;
  Take(CompileProject(document_->project()));
}

// What became of the document as it is now.
void Session::Take(Result<Compiled> compiled) {
  if (compiled_revision_ == document_->revision()) return;
  compiled_revision_ = document_->revision();
  compile_error_.reset();
  if (!compiled.ok()) {
    compile_error_ = compiled.error();
    animation_.reset();
    return;
  }
  animation_ = std::move(compiled).value().animation;
  if (animation_->figure != figure_) TakeFigure(animation_->figure);
  if (bake_) {
    bake_->Update(*animation_);
  } else {
    bake_ = std::make_unique<BackgroundBake>(*animation_);
  }
}

const Animation* Session::animation() {
  Compile();
  return animation_ ? &*animation_ : nullptr;
}

Result<const Motion*> Session::MotionTo(int frame) {
  Compile();
  if (compile_error_) return *compile_error_;
  if (const std::optional<Error> error = bake_->BakeTo(frame, patience_)) return *error;
  return &bake_->motion();
}

Result<const Motion*> Session::ShownMotionTo(int frame) {
  Result<const Motion*> motion = MotionTo(frame);
  if (motion.ok() || compile_error_) return motion;
  const std::vector<MotionFrame>& frames = bake_->motion().frames;
  const size_t count = frame - project().frames.first + 1;
  const auto is_there = [this](const MotionFrame& f) {
    return f.q.size() == figure_->num_joints();
  };
  if (frames.size() < count || !std::all_of(frames.begin(), frames.begin() + count, is_there)) {
    return motion;
  }
  return &bake_->motion();
}

Result<const Motion*> Session::WholeMotion() { return MotionTo(document_->project().frames.last); }

std::optional<Error> Session::KnownError() {
  Compile();
  return compile_error_ ? compile_error_ : bake_->error();
}

Result<const MotionFrame*> Session::FrameNow() {
  const int frame = NearestFrame();
  const Result<const Motion*> motion = MotionTo(frame);
  if (!motion.ok()) return motion.error();
  return &motion.value()->frames[frame - project().frames.first];
}

Result<const MotionFrame*> Session::ShownFrame() {
  const int frame = NearestFrame();
  const Result<const Motion*> motion = ShownMotionTo(frame);
  if (!motion.ok()) return motion.error();
  return &motion.value()->frames[frame - project().frames.first];
}

int Session::NearestFrame() const {
  const ProjectFrames& frames = project().frames;
  return std::clamp(static_cast<int>(std::lround(frame_)), frames.first, frames.last);
}

void Session::StopBaking() {
  if (bake_) bake_->Stop();
}

void Session::ResumeBaking() {
  if (bake_) bake_->Resume();
}

Result<double> Session::ValueNow(const std::string& curve) {
  const Result<const MotionFrame*> now = FrameNow();
  if (!now.ok()) return now.error();
  if (const auto of_root = RootCurveNamed(curve)) {
    return WithoutRoundOff(RootValues(now.value()->X_WR, project().root, frame_)[*of_root]);
  }
  if (const auto held = ObjectCurveNamed(curve, project())) {
    return WithoutRoundOff(now.value()->objects[held->object].X_WO.p[held->axis]);
  }
  const std::optional<JointIndex> hinge = figure_->FindJoint(curve);
  if (!hinge) return Error{ErrorCode::kSchema, "", "joint", "there is no hinge \"" + curve + "\""};
  return WithoutRoundOff(now.value()->q[hinge->value()] / kDegree);
}

}  // namespace hazumi::edit
