#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "engine/bake/incremental_bake.h"
#include "engine/base/result.h"

namespace hazumi::makers {

// Bakes of the trials of a maker, which plans keys, bakes them and corrects the plan by their
// motion. Counts their work (Work), not their time, so that every machine finds the same plan.
class TrialBakes {
 public:
  // `exhausted`: the error after `most_work`.
  TrialBakes() = default;
  TrialBakes(double most_work, Error exhausted)
      : most_work_(most_work), exhausted_(std::move(exhausted)) {}

  // Bakes up to and including a frame. Keeps what the animation shares with the trial before.
  // Errors: those of the bake, and the one for too much work.
  Result<const Motion*> BakeTo(int frame, const Animation& animation);
  // Motion of the latest trial.
  const Motion& motion() const { return bake_->motion(); }

  // Work of all trials.
  double work() const;
  // Leaves at most this much work for the trials to come.
  void LeaveWork(double most) { most_work_ = std::min(most_work_, work() + most); }

 private:
  double most_work_ = std::numeric_limits<double>::infinity();
  Error exhausted_;
  std::unique_ptr<IncrementalBake> bake_;
  double updates_ = 0.0;
};

}  // namespace hazumi::makers
