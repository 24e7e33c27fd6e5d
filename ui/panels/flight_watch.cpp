#include "ui/panels/flight_watch.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

namespace {

bool IsByGravity(const Flight& flight, const std::vector<PlacementSpan>& placements) {
  const double middle = 0.5 * (flight.take_off + flight.landing);
  return std::any_of(placements.begin(), placements.end(), [&](const PlacementSpan& span) {
    return span.kind == PlacementKind::kGravity && middle > span.first_frame &&
           middle < span.last_frame;
  });
}

// Keys made by hand may fly as they like: what no common frame rate explains is not said aloud.
bool IsAlarming(const TimeScale& time) {
  return time.verdict == TimeVerdict::kWrongLength ||
         (time.verdict == TimeVerdict::kWrongFrameTime && time.frame_rate);
}

}  // namespace

FlightWatch::~FlightWatch() {
  if (job_) job_->thread.join();
}

void FlightWatch::Look(edit::Session* session) {
  if (job_ && job_->has_ended) End();
  const Version now = {session->document_number(), session->document().revision()};
  if (job_ || now == seen_ || session->document().is_merging()) return;
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return;  // it may be there the next time
  seen_ = now;
  Begin(session, *motion.value());
  if (!session->patience()) End();
}

void FlightWatch::Begin(edit::Session* session, const Motion& motion) {
  const Animation& animation = *session->animation();
  job_ = std::make_unique<Job>();
  job_->figure = animation.figure;
  job_->motion = motion;
  job_->size_is_guessed = session->project().size_is_guessed;
  job_->gravity = animation.gravity;
  job_->placements = animation.placements;
  job_->thread = std::thread([job = job_.get()] {
    MotionSeries series = SeriesOf(*job->figure, job->motion);
    series.scale_known = !job->size_is_guessed;
    job->analysis = AnalyseFlights(series, job->gravity);
    job->has_ended = true;
  });
}

void FlightWatch::End() {
  job_->thread.join();
  analysis_ = std::move(job_->analysis);
  std::erase_if(analysis_.flights,
                [&](const Flight& flight) { return IsByGravity(flight, job_->placements); });
  job_.reset();
  if (!IsAlarming(analysis_.time) || analysis_.flights.empty() || alarmed_ == seen_.document)
    return;
  alarmed_ = seen_.document;
  has_alarm_ = true;
}

int FirstFrameOf(const Flight& flight) { return static_cast<int>(std::ceil(flight.take_off)); }
int LastFrameOf(const Flight& flight) { return static_cast<int>(std::floor(flight.landing)); }

}  // namespace hazumi::ui
