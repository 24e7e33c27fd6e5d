#include "engine/makers/trial_bakes.h"

namespace hazumi::makers {

double TrialBakes::work() const {
  constexpr double kOfAnUpdate = 5000.0;  // besides what the bake counts
  return bake_ ? bake_->work() + kOfAnUpdate * updates_ : 0.0;
}

Result<const Motion*> TrialBakes::BakeTo(int frame, const Animation& animation) {
  if (bake_) {
    bake_->Update(animation);
    updates_ += 1.0;
  } else {
    BakeOptions options;
    options.threads = 1;  // trials are short: threads would wait longer than they work
    bake_ = std::make_unique<IncrementalBake>(animation, options);
  }
  if (const auto error = bake_->BakeTo(frame)) return *error;
  return &bake_->motion();
}

}  // namespace hazumi::makers
