// Where a region's error estimate is above a fifth of its tolerance the stretch is solved again,
// with steps finer by three times what is missing, as long as each time takes the estimate down to
// 0.3 of what it was: the error is at times a few times the estimate, and some motions are so
// sensitive that no step tells their end [METHOD 8.2, 8.3].

#include "engine/bake/walk/refinements.h"

#include <algorithm>

#include "engine/base/text.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kFinest = 1e6, kSafely = 0.2;

void WarnOfSensitivity(int region, double estimate, Recorder* recorder) {
  recorder->AddWarning("regions[" + std::to_string(region) + "]",
                       "its angles may be off by " + FormatShort(estimate / kDegree) +
                           " degrees, more than its tolerance: the motion is so sensitive that "
                           "finer steps do not help");
}

}  // namespace

double Refinements::SharpnessOf(const std::vector<int>& regions) const {
  double sharpness = 1.0;
  for (const int r : regions) sharpness = std::max(sharpness, of_region_[r].sharpness);
  return sharpness;
}

bool Refinements::Sharpen(const std::vector<int>& regions, Recorder* recorder) {
  bool any = false;
  for (const int r : regions) {
    const RegionReport& report = recorder->report(r);
    Refinement& refinement = of_region_[r];
    const double estimate = report.error_estimate, safe = kSafely * report.tolerance;
    if (report.method != Method::kExact || estimate <= safe) continue;
    const double finer = refinement.sharpness * 3.0 * estimate / safe;
    // What tumbles was that sensitive before its contacts were frozen.
    const bool tumbles = report.estimated_until.has_value();
    if (tumbles || finer > kFinest || estimate > 0.3 * refinement.last_estimate) {
      if (estimate > report.tolerance) WarnOfSensitivity(r, estimate, recorder);
      continue;
    }
    refinement = {finer, estimate};
    any = true;
  }
  return any;
}

}  // namespace hazumi
