#include "ui/panels/timeline/flight_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/problems/problems.h"
#include "engine/base/memory.h"

namespace hazumi::ui {

namespace {

// Keys made by hand may fly as they like: what no common frame rate explains is not said aloud.
bool IsAlarming(const TimeScale& time) {
  return time.verdict == TimeVerdict::kWrongLength || RateToSet(time).has_value();
}

}  // namespace

FlightWatch::~FlightWatch() {
  if (job_) job_->thread.join();
}

void FlightWatch::Look(edit::Session* session) {
  const Version now = {session->document_number(), session->document().revision()};
  if (now.document != shown_) {
    shown_ = now.document;
    analysis_ = {};
    has_alarm_ = false;
  }
  if (job_ && job_->has_ended) End(now.document);
  if (job_ || now == seen_ || session->document().is_merging()) return;
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return;  // it may be there the next time
  seen_ = now;
  Begin(session, *motion.value());
  if (!session->patience()) End(now.document);
}

void FlightWatch::Begin(edit::Session* session, const Motion& motion) {
  const Animation& animation = *session->animation();
  job_ = std::make_unique<Job>();
  job_->document = session->document_number();
  job_->figure = animation.figure;
  job_->motion = motion;
  job_->size_is_guessed = session->project().size_is_guessed;
  job_->gravity = animation.gravity;
  job_->placements = animation.placements;
  job_->thread = std::thread([job = job_.get()] {
    const auto analyse = [job]() -> Result<FlightAnalysis> {
      MotionSeries series = SeriesOf(*job->figure, job->motion);
      series.scale_known = !job->size_is_guessed;
      return AnalyseFlights(series, job->gravity);
    };
    if (Result<FlightAnalysis> found = WithinMemory(analyse); found.ok()) {
      job->analysis = std::move(found).value();
    }
    job->has_ended = true;
  });
}

void FlightWatch::End(long document) {
  job_->thread.join();
  const std::unique_ptr<Job> job = std::move(job_);
  if (job->document != document) return;
  analysis_ = WithoutGravity(std::move(job->analysis), job->placements);
  if (!IsAlarming(analysis_.time) || alarmed_ == document) return;
  alarmed_ = document;
  has_alarm_ = true;
}

int FirstFrameOf(const Flight& flight) { return static_cast<int>(std::ceil(flight.take_off)); }
int LastFrameOf(const Flight& flight) { return static_cast<int>(std::floor(flight.landing)); }

}  // namespace hazumi::ui
