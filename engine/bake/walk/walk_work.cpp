// Work limit of a bake. Work is counted, not timed, so that a project ends in the same frame on
// every machine.

#include "engine/bake/walk/walk_work.h"

#include "engine/bake/walk/exact_walk.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

// Limits in accelerations of one body. Some seconds of computing with all that Work counts.
constexpr double kMostWork = 2e7, kMostWorkPerSecond = 1e7, kMostForBody = 1e5;

}  // namespace

std::string TooMuch(const Work& work) {
  switch (work.largest()) {
    case Work::On::kSearches:
      return "it takes too much work, most of it to look for what it touches, so fast does it "
             "move; slow it down, or take its contacts away";
    case Work::On::kLimits:
      return "it takes too much work, most of it for limits that are met again and again; widen "
             "them, or give the joints more friction";
    case Work::On::kContacts:
      return "it takes too much work, most of it for contacts that change again and again; let "
             "less of it touch, or take its contacts away";
    case Work::On::kMotion:
      break;
  }
  return "it takes too much work, most of it in short steps; lower rates, frequencies of springs "
         "or forces, or ask for less accuracy";
}

void ExactWalk::DropDriver() {
  if (driver_) work_before_ += driver_->work().total();
  driver_.reset();
}

std::optional<Error> ExactWalk::CheckWork(double frame) {
  const double work = work_before_ + driver_->work().total();
  const double seconds = context_.Seconds(frame) - context_.Seconds(stretch_start_);
  const double for_bodies = kMostForBody * driver_->num_bodies() * (1.0 + seconds);
  if (work - work_before_stretch_ > kMostWork + kMostWorkPerSecond * seconds + for_bodies) {
    return CannotGoOnAfter(frame, driver_->CostliestJoint(), TooMuch(driver_->work()));
  }
  if (work <= context_.options.most_work) return std::nullopt;
  const Error error = CannotGoOnAfter(frame, driver_->CostliestJoint(), TooMuch(driver_->work()));
  const int last = static_cast<int>(frame);
  context_.ended_early =
      Warning{error.place,
              "frames after " + std::to_string(last) + " are not checked: " + error.message, last};
  return Error{ErrorCode::kInterrupted, "", "", "it takes too much work"};
}

}  // namespace hazumi
