#pragma once

#include <memory>

#include "engine/bake/incremental_bake.h"
#include "engine/base/result.h"

namespace hazumi::makers {

// Bakes of the trials of a maker, which plans keys, bakes them and corrects the plan by their
// motion. Counts their work (Work), not their time, so that every machine finds the same plan.
class TrialBakes {
 public:
  // Bakes up to and including a frame. Keeps what the animation shares with the trial before.
  // Errors: those of the bake.
  Result<const Motion*> BakeTo(int frame, const Animation& animation);
  // Motion of the latest trial.
  const Motion& motion() const { return bake_->motion(); }

  // Work of all trials.
  double work() const;

 private:
  std::unique_ptr<IncrementalBake> bake_;
  double updates_ = 0.0;
};

}  // namespace hazumi::makers
