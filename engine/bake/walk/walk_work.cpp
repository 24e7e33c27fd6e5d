// Work limit of a bake. Work is counted, not timed, so that a project ends in the same frame on
// every machine.

#include "engine/bake/walk/walk_work.h"

#include "engine/bake/walk/exact_walk.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

// Limits in accelerations of one body. Some seconds of computing with all that Work counts.
constexpr double kMostWork = 2e7, kMostWorkPerSecond = 1e7, kMostForBody = 1e5;
// Part of the work of landings that BakeOptions::most_work leaves out: keyed clips of minutes,
// whose frames take nothing else, are checked to their end.
constexpr double kSpared = 0.8;

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
    case Work::On::kLandings:
      return "it takes too much work, most of it to look for where the figure lands; move the "
             "figure out of what it is inside of, or lower the rates of its joints";
    case Work::On::kMotion:
      break;
  }
  return "it takes too much work, most of it in short steps; lower rates, frequencies of springs "
         "or forces, or ask for less accuracy";
}

Work ExactWalk::WorkNow() const {
  constexpr double kPlacing = 0.3, kPair = 0.4;  // of a link, and of it with an object
  Work work = driver_ ? driver_->work() : Work();
  const double links = static_cast<double>(context_.animation.figure->links().size());
  const double objects = static_cast<double>(context_.animation.scene.size());
  work.landings += poses_looked_at_ * links * (kPlacing + kPair * objects);
  return work;
}

Work ExactWalk::work() const {
  Work work = work_before_;
  work += WorkNow();
  return work;
}

void ExactWalk::DropDriver() {
  work_before_ = work();
  poses_looked_at_ = 0.0;
  driver_.reset();
}

std::optional<Error> ExactWalk::CheckWork(double frame) {
  const Work work = this->work();
  const double seconds = context_.Seconds(frame) - context_.Seconds(stretch_start_);
  const int bodies = driver_ ? driver_->num_bodies() : 0;
  const double most =
      kMostWork + kMostWorkPerSecond * seconds + kMostForBody * bodies * (1.0 + seconds);
  const bool is_too_much = work.total() - work_before_stretch_ > most;
  const bool is_enough = work.total() - kSpared * work.landings > context_.options.most_work;
  if (!is_too_much && !is_enough) return std::nullopt;
  const JointIndex joint = driver_ ? driver_->CostliestJoint() : JointIndex();
  Work now = WorkNow();
  if (!is_too_much) now.landings *= 1.0 - kSpared;
  const Error error = CannotGoOnAfter(frame, joint, TooMuch(now));
  if (is_too_much) return error;
  const int last = static_cast<int>(frame);
  context_.ended_early =
      Warning{error.place,
              "frames after " + std::to_string(last) + " are not checked: " + error.message, last};
  return Error{ErrorCode::kInterrupted, "", "", "it takes too much work"};
}

}  // namespace hazumi
