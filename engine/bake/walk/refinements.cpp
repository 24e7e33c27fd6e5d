// Refinement of a region with steps of increasing sharpness, S_0 = 1, S_1 = 30, S_2 = 900 ... The
// motion is that of S_i up to the first frame where the error estimate of S_i exceeds a tenth of
// the tolerance (a miss), and that of S_(i+1) from there on, or of S_(i+2) if that does not help. A
// refinement has to reduce the estimate at that frame to 0.3 of its value: the error is at times a
// few times the estimate, and some motions are so sensitive that no step size predicts their end.
// No frame depends on later frames; but S_(i+1) may show that S_i was farther off before the miss
// than it estimated, which is the estimate then. [METHOD 8.2, 8.3]
// Version 1 of the solver solves the whole stretch again. Its steps are finer by three times the
// factor by which the end misses the tolerance.

#include "engine/bake/walk/refinements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/text.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kFinest = 1e6, kHelps = 0.3, kFiner = 30.0;
// Share of the tolerance that an estimate may be. The control solution is then at most half the
// tolerance away: where steps are too coarse for an estimate the error is of that order.
constexpr double kSafely = 0.1, kSafelyInVersion1 = 0.2;
constexpr int kMostTries = 2;
constexpr size_t kMostKept = 300;  // frames
// Factor of the estimate if finer steps do not help, or cannot be solved: four times the distance
// from the control solution, in place of a fifth of it, since neither solution need be near. It is
// more than the tolerance then, which a warning says.
constexpr double kSensitive = 20.0;
static_assert(kSensitive * kSafely > 1.0);

constexpr const char* kIsSensitive = "the motion is so sensitive that finer steps do not help";
constexpr const char* kWasMissed = "finer steps, which later frames needed, tell so";
constexpr const char* kFailsFiner = "finer steps cannot be solved, or take too much work";

void WarnOfError(int region, double estimate, const char* why, Recorder* recorder) {
  recorder->AddWarning("regions[" + std::to_string(region) + "]",
                       "its angles may be off by " + FormatShort(estimate / kDegree) +
                           " degrees, more than its tolerance: " + why);
}

}  // namespace

double Refinements::SharpnessOf(const std::vector<int>& regions) const {
  double sharpness = 1.0;
  for (const int r : regions) sharpness = std::max(sharpness, of_region_[r].sharpness);
  return sharpness;
}

void Refinements::Reset() {
  of_region_.assign(animation_.regions.size(), Refinement());
  angles_.clear();
  first_miss_.reset();
}

const VecX* Refinements::KeepAngles(int frame, VecX angles) {
  if (first_miss_ && frame < *first_miss_) {
    const auto kept = angles_.find(frame);
    return kept == angles_.end() ? nullptr : &kept->second;
  }
  angles_[frame] = std::move(angles);
  if (angles_.size() > kMostKept) angles_.erase(angles_.begin());
  return nullptr;
}

void Refinements::NoteKept(int region, double distance) {
  double& largest = of_region_[region].kept_distance;
  largest = std::max(largest, distance);
}

size_t Refinements::IndexOf(int region, int frame) const {
  return static_cast<size_t>(frame - animation_.regions[region].first_frame);
}

double Refinements::SafeFor(int region) const {
  const DynamicsRegion& own = animation_.regions[region];
  return kSafely * own.tolerance.value_or(animation_.solver.tolerance);
}

void Refinements::Note(int region, int frame, double estimate, const std::vector<int>& regions) {
  Refinement& own = of_region_[region];
  const size_t index = IndexOf(region, frame);
  own.estimates.resize(std::max(own.estimates.size(), index + 1), 0.0);
  own.solved_with.resize(own.estimates.size(), 1.0);
  own.estimates[index] = estimate;
  own.solved_with[index] = SharpnessOf(regions);
  if (own.missed_at != frame || own.is_settled) return;
  own.is_no_help = estimate > kHelps * own.missed_by;
  is_no_help_ |= own.is_no_help;
  if (!own.is_no_help) own.tries = 0;
}

void Refinements::GiveUp() {
  for (size_t r = 0; r < of_region_.size(); ++r) {
    const Refinement& own = of_region_[r];
    if (!own.missed_at || (is_no_help_ && !own.is_no_help)) continue;
    Refinement& kept = before_[r];
    kept.missed_at = own.missed_at;
    kept.tries = own.tries + 1;
    kept.has_failed |= !is_no_help_;
    kept.is_settled |= kept.has_failed || kept.tries == kMostTries;
  }
  of_region_ = before_;
  angles_ = angles_before_;
  is_no_help_ = false;
}

std::optional<int> Refinements::FirstMiss(int region) const {
  const std::vector<double>& estimates = of_region_[region].estimates;
  const double safe = SafeFor(region);
  const auto miss = std::find_if(estimates.begin(), estimates.end(),
                                 [&](double estimate) { return estimate > safe; });
  if (miss == estimates.end()) return std::nullopt;
  return animation_.regions[region].first_frame + static_cast<int>(miss - estimates.begin());
}

double Refinements::EstimateBefore(int region, int frame) const {
  const int index = frame - 1 - animation_.regions[region].first_frame;
  return index < 0 ? 0.0 : of_region_[region].estimates[static_cast<size_t>(index)];
}

// Sharpness to try at a miss.
double Refinements::FinerAt(int region, int frame) const {
  const Refinement& own = of_region_[region];
  const int tries = own.missed_at == frame ? own.tries : 0;
  return std::pow(kFiner, 1 + tries) * own.solved_with[IndexOf(region, frame)];
}

std::optional<int> Refinements::SharpenFromFirstMiss(const std::vector<int>& regions) {
  std::optional<int> first;
  for (const int r : regions) {
    Refinement& own = of_region_[r];
    const std::optional<int> miss = own.is_settled ? std::nullopt : FirstMiss(r);
    own.is_settled |= miss && FinerAt(r, *miss) > kFinest;
    if (miss && !own.is_settled && (!first || *miss < *first)) first = miss;
  }
  before_ = of_region_;
  angles_before_ = angles_;
  first_miss_ = first;
  for (const int r : regions) {
    Refinement& own = of_region_[r];
    const bool asks = first && !own.is_settled && FirstMiss(r) == first;
    if (asks) {
      own.sharpness = FinerAt(r, *first);
      own.missed_by = own.estimates[IndexOf(r, *first)];
      own.kept_estimate = std::max(own.kept_estimate, EstimateBefore(r, *first));
    }
    own.missed_at = asks ? first : std::nullopt;
    own.is_no_help = false;
  }
  return first;
}

void Refinements::Report(const std::vector<int>& regions, Recorder* recorder) const {
  for (const int r : regions) {
    RegionReport& report = recorder->report(r);
    if (report.method != Method::kExact) continue;
    const Refinement& own = of_region_[r];
    report.error_estimate = std::max(report.error_estimate, own.kept_estimate);
    const bool is_unconfirmed = own.is_settled && own.tries > 0;
    if (is_unconfirmed) report.error_estimate *= kSensitive;
    const bool is_of_kept = own.kept_distance > report.error_estimate;
    report.error_estimate = std::max(report.error_estimate, own.kept_distance);
    if (report.error_estimate <= report.tolerance) continue;
    const char* const why = is_of_kept ? kWasMissed : own.has_failed ? kFailsFiner : kIsSensitive;
    WarnOfError(r, report.error_estimate, why, recorder);
  }
}

bool Refinements::SharpenAll(const std::vector<int>& regions, Recorder* recorder) {
  bool any = false;
  for (const int r : regions) {
    const RegionReport& report = recorder->report(r);
    Refinement& refinement = of_region_[r];
    const double estimate = report.error_estimate, safe = kSafelyInVersion1 * report.tolerance;
    if (report.method != Method::kExact || estimate <= safe) continue;
    const double finer = refinement.sharpness * 3.0 * estimate / safe;
    // A body that tumbles was that sensitive before time-stepping mode was entered.
    const bool tumbles = report.estimated_until.has_value();
    if (tumbles || finer > kFinest || estimate > 0.3 * refinement.last_estimate) {
      if (estimate > report.tolerance) WarnOfError(r, estimate, kIsSensitive, recorder);
      continue;
    }
    refinement.sharpness = finer;
    refinement.last_estimate = estimate;
    any = true;
  }
  return any;
}

}  // namespace hazumi
