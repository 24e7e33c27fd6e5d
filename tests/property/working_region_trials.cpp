#include "tests/property/working_region_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>

#include "engine/bake/bake.h"
#include "engine/project/checks/animation_checks.h"
#include "engine/spatial/degrees.h"
#include "tests/property/random_region.h"
#include "tests/support/from_environment.h"

namespace hazumi::test {

namespace {

constexpr double kChaos = 10 * kTolerance;  // references differ by more [deg]

// Says that the scene cannot be, and not that it is hard.
bool IsReason(const Error& error) {
  for (const char* hard : {"too much work", "faster than any step"}) {
    if (error.message.find(hard) != std::string::npos) return false;
  }
  return error.code == ErrorCode::kSemantics;
}

bool IsFinite(const Motion& motion) {
  return std::all_of(motion.frames.begin(), motion.frames.end(), [](const MotionFrame& frame) {
    return frame.q.allFinite() && frame.after.qd.allFinite() && frame.X_WR.p.allFinite() &&
           frame.X_WR.R.allFinite();
  });
}

// Without another try where the estimate is above the tolerance.
Result<Motion> ReferenceAt(Animation animation, double share) {
  animation.solver.tolerance = share * kTolerance * kDegree;
  BakeOptions options;
  options.refine = false;
  return Bake(animation, options);
}

// The last frame whose error is estimated.
double EstimatedUntil(const Motion& motion) {
  double until = HUGE_VAL;
  for (const RegionReport& report : motion.regions) {
    until = std::min(until, report.estimated_until.value_or(HUGE_VAL));
  }
  return until;
}

// The first frame from which events of neighbouring tolerances differ.
double BranchesFrom(const Motion& motion) {
  double from = HUGE_VAL;
  for (const RegionReport& report : motion.regions) {
    from = std::min(from, report.branches_from.value_or(HUGE_VAL));
  }
  return from;
}

bool HasWarning(const char* words, const Motion& motion) {
  return std::any_of(motion.warnings.begin(), motion.warnings.end(), [&](const Warning& warning) {
    return warning.message.find(words) != std::string::npos;
  });
}

// Whether a warning reports an error of that size [deg], to a factor of ten.
bool WarnsOf(double error, const Motion& motion) {
  double estimate = 0.0;
  for (const RegionReport& report : motion.regions) {
    estimate = std::max(estimate, report.error_estimate / kDegree);
  }
  return HasWarning("angles may be off", motion) && error <= 10.0 * estimate;
}

void LookAtAccount(const Motion& motion, Trial* trial) {
  if (!motion.regions[0].energy) return;
  const EnergyBalance& energy = *motion.regions[0].energy;
  trial->account = std::abs(energy.residual()) / std::max(energy.turnover(), 1e-6);
  trial->is_open = energy.is_open();
  trial->is_open_unsaid = trial->is_open && !HasWarning("unexplained", motion);
}

// Two solutions with finer steps than usual.
struct References {
  Result<Motion> coarse, fine;
  double apart = HUGE_VAL;  // up to some frame [deg]; unknown if one of them failed
};

// Returns the two references that agree best up to a frame, and to the last one whose error each of
// them estimates.
References BestOf(const Animation& animation, const std::map<double, Result<Motion>>& by_share,
                  double until) {
  for (const auto& [share, motion] : by_share) {
    if (motion.ok()) until = std::min(until, EstimatedUntil(motion.value()));
  }
  std::optional<References> best;
  for (auto coarse = by_share.begin(); coarse != by_share.end(); ++coarse) {
    for (auto fine = by_share.begin(); fine != coarse; ++fine) {
      References pair = {coarse->second, fine->second};
      if (pair.coarse.ok() && pair.fine.ok()) {
        pair.apart = FurthestApart(animation, pair.coarse.value(), pair.fine.value(), until);
      }
      if (!best || pair.apart < best->apart) best = std::move(pair);
    }
  }
  return *best;
}

// Returns the two of up to seven references that agree best: rounding grows with the number of
// steps, and now and then it decides the order of two hits, so that the finest one is not always
// the best. None are added once two are within a tenth of the tolerance.
References ReferencesOf(const Animation& animation, double until) {
  std::map<double, Result<Motion>> by_share;  // of the tolerance
  for (const double share : {1e-4, 1e-5}) by_share.emplace(share, ReferenceAt(animation, share));
  References best = BestOf(animation, by_share, until);
  for (const double share : {1e-3, 3e-4, 3e-5, 3e-6, 1e-6}) {
    if (best.apart < 0.1 * kTolerance) break;
    by_share.emplace(share, ReferenceAt(animation, share));
    best = BestOf(animation, by_share, until);
  }
  return best;
}

void Count(const Trial& trial, Tally* tally) {
  ++tally->cases;
  tally->failed += trial.outcome == Outcome::kFailed;
  tally->refused += trial.outcome == Outcome::kRefused;
  tally->unreferenced += trial.outcome == Outcome::kUnreferenced;
  tally->chaotic += trial.outcome == Outcome::kChaotic;
  if (trial.account >= 0.0) {
    ++tally->accounts;
    tally->open += trial.is_open;
    tally->unsaid += trial.is_open_unsaid;
    tally->worst_account = std::max(tally->worst_account, trial.account);
  }
  if (trial.outcome != Outcome::kCompared) return;
  ++tally->compared;
  const bool is_close = trial.error <= kTolerance;
  tally->reported += !is_close && trial.is_reported;
  tally->too_far += !is_close && !trial.is_reported;
  tally->worst = std::max(tally->worst, trial.error);
}

void Print(const char* what, const Tally& tally) {
  std::printf(
      "%-12s %4d cases, %d failed, %d refused with a reason, %d without a reference, %d chaotic, "
      "%d compared, %d beyond the tolerance without a warning and %d with one, worst %.3g deg; %d "
      "accounts, %d open, %d of them without a warning, worst %.2g\n",
      what, tally.cases, tally.failed, tally.refused, tally.unreferenced, tally.chaotic,
      tally.compared, tally.too_far, tally.reported, tally.worst, tally.accounts, tally.open,
      tally.unsaid, tally.worst_account);
}

void PrintOdd(int seed, const WorkingRegion& region, const Trial& trial) {
  const bool is_close = trial.outcome == Outcome::kCompared && trial.error <= kTolerance;
  if (is_close && !trial.is_open) return;
  std::string acting;
  for (const Acting each : kAllActing) {
    if (region.has(each)) acting += std::string(acting.empty() ? "" : ", ") + NameOf(each);
  }
  constexpr const char* kNames[] = {"", "failed", "refused", "no reference", "chaotic", "compared"};
  std::printf("seed %d (%s): %s, error %.3g deg%s, references %.3g deg apart, account %.2g %s\n",
              seed, acting.c_str(), kNames[static_cast<int>(trial.outcome)], trial.error,
              trial.is_reported ? " (reported)" : "", trial.apart, trial.account,
              trial.message.c_str());
  std::fflush(stdout);
}

// Such as a file may say it.
void ExpectValid(int seed, const Animation& animation) {
  FirstError errors;
  CheckAnimation(animation, nullptr, &errors);
  EXPECT_TRUE(errors.ok()) << "seed " << seed << ": " << errors.error()->ToString();
}

}  // namespace

// Largest error up to a frame [deg].
double FurthestApart(const Animation& animation, const Motion& a, const Motion& b, double until) {
  double worst = 0.0;
  for (size_t r = 0; r < animation.regions.size(); ++r) {
    worst = std::max(worst, LargestError(animation, a, b, r, until) / kDegree);
  }
  return worst;
}

Trial Try(const Animation& drawn) {
  Animation animation = drawn;
  animation.solver.tolerance = kTolerance * kDegree;
  Trial trial;
  BakeOptions options;
  options.energy = true;
  const Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) {
    trial.outcome = IsReason(motion.error()) ? Outcome::kRefused : Outcome::kFailed;
    trial.message = motion.error().ToString();
    return trial;
  }
  if (!IsFinite(motion.value())) {
    trial.outcome = Outcome::kFailed;
    trial.message = "not finite";
    return trial;
  }
  LookAtAccount(motion.value(), &trial);
  double until = std::min(EstimatedUntil(motion.value()), BranchesFrom(motion.value()));
  const References references = ReferencesOf(animation, until);
  const Result<Motion>&one = references.coarse, &two = references.fine;
  for (const auto* reference : {&one, &two}) {
    if (reference->ok()) continue;
    trial.outcome = Outcome::kUnreferenced;
    trial.message = reference->error().ToString();
    return trial;
  }
  until = std::min(until, EstimatedUntil(two.value()));
  trial.apart = FurthestApart(animation, one.value(), two.value(), until);
  trial.error = FurthestApart(animation, motion.value(), two.value(), until);
  trial.is_reported = WarnsOf(trial.error, motion.value());
  trial.outcome = trial.apart > kChaos ? Outcome::kChaotic : Outcome::kCompared;
  return trial;
}

void Trials::Add(int seed) {
  const WorkingRegion region = RandomWorkingRegion(static_cast<uint64_t>(seed));
  ExpectValid(seed, region.animation);
  const Trial trial = Try(region.animation);
  Count(trial, &all_);
  for (const Acting each : kAllActing) {
    if (region.has(each)) Count(trial, &by_acting_[static_cast<size_t>(each)]);
  }
  PrintOdd(seed, region, trial);
}

void Trials::Expect() const {
  for (const Acting each : kAllActing) Print(NameOf(each), by_acting_[static_cast<size_t>(each)]);
  Print("all", all_);
  EXPECT_LE(all_.failed, MostOf(all_.cases, 0.005));
  EXPECT_LE(all_.unreferenced, MostOf(all_.cases, 0.02));
  EXPECT_EQ(all_.unsaid, 0);
  EXPECT_LE(all_.open, MostOf(all_.accounts, 0.005));
  EXPECT_LE(all_.chaotic, MostOf(all_.cases, 0.1));
  EXPECT_LE(all_.too_far, MostOf(all_.compared, 0.01));
  EXPECT_LE(all_.reported, MostOf(all_.compared, 0.01));
}

}  // namespace hazumi::test
