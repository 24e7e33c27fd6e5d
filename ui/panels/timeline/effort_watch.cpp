#include "ui/panels/timeline/effort_watch.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/bake/bake.h"
#include "engine/base/memory.h"

namespace hazumi::ui {

namespace {

constexpr double kQuick = 0.06;  // it may be done anew while something is dragged [s]

struct Found {
  Effort effort;
  std::vector<MissingSupport> missing;
};

Result<Found> FindIn(const Animation& animation, const std::atomic<bool>* cancel) {
  BakeOptions options;
  options.accelerations = true;
  options.cancel = cancel;
  const Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) return motion.error();
  Found found{EffortOf(animation, motion.value()), {}};
  found.missing = MissingSupports(animation, motion.value(), found.effort);
  return found;
}

}  // namespace

EffortWatch::~EffortWatch() {
  if (!job_) return;
  job_->cancel = true;
  job_->thread.join();
}

void EffortWatch::Look(edit::Session* session) {
  const Version now = {session->document_number(), session->document().revision()};
  if (now.document != shown_) Forget();
  shown_ = now.document;
  const bool is_dragged = session->document().is_merging();
  // What takes long is not waited for if it is of a motion that is no more.
  if (job_ && !(job_->of == now) && !is_dragged) job_->cancel = true;
  if (job_ && job_->has_ended) End();
  if (job_ || now == seen_ || (is_dragged && seconds_ > kQuick)) return;
  if (!session->WholeMotion().ok()) return;  // it may be there the next time
  seen_ = now;
  Begin(*session->animation(), now);
  if (!session->patience()) End();
}

void EffortWatch::Begin(const Animation& animation, Version version) {
  job_ = std::make_unique<Job>();
  job_->of = version;
  job_->animation = animation;
  job_->thread = std::thread([job = job_.get()] {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto find = [job] { return FindIn(job->animation, &job->cancel); };
    if (Result<Found> found = WithinMemory(find); found.ok()) {
      job->effort = std::move(found.value().effort);
      job->missing = std::move(found.value().missing);
    }
    job->seconds = std::chrono::duration<double>(Clock::now() - start).count();
    job->has_ended = true;
  });
}

void EffortWatch::End() {
  job_->thread.join();
  const std::unique_ptr<Job> job = std::move(job_);
  if (job->of.document != shown_ || job->cancel) return;
  first_frame_ = job->animation.first_frame;
  effort_ = std::move(job->effort);
  missing_ = std::move(job->missing);
  seconds_ = job->seconds;
  ++number_;
}

void EffortWatch::Forget() {
  if (job_) {
    job_->cancel = true;
    if (job_->has_ended) End();
  }
  if (!is_there() && missing_.empty() && seen_ == Version()) return;
  effort_ = {};
  missing_.clear();
  seen_ = {};
  ++number_;
}

const FrameEffort* EffortWatch::At(int frame) const {
  const int i = frame - first_frame_;
  const bool is_there = i >= 0 && i < static_cast<int>(effort_.frames.size());
  return is_there ? &effort_.frames[static_cast<size_t>(i)] : nullptr;
}

bool HasStrengths(const Figure& figure) {
  return std::any_of(figure.joints().begin(), figure.joints().end(),
                     [](const Joint& joint) { return joint.strength.has_value(); });
}

double LargestShare(const FrameEffort& effort, JointIndex first, int count) {
  return effort.share.segment(first.value(), count).maxCoeff();
}

}  // namespace hazumi::ui
