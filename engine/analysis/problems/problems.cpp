#include "engine/analysis/problems/problems.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hazumi {

namespace {

constexpr double kFarSlide = 0.05;  // shortest slide that is reported; captures have shorter ones
                                    // in every step [m]

bool IsByGravity(const Flight& flight, const std::vector<PlacementSpan>& placements) {
  const double middle = 0.5 * (flight.take_off + flight.landing);
  return std::any_of(placements.begin(), placements.end(), [&](const PlacementSpan& span) {
    return span.kind == PlacementKind::kGravity && middle > span.first_frame &&
           middle < span.last_frame;
  });
}

// Whether a warning of the bake is about a ball that is released inside an object.
bool IsWarnedOf(const FallThrough& fall, const Motion& motion) {
  return std::any_of(motion.warnings.begin(), motion.warnings.end(), [&](const Warning& warning) {
    return IndexIn("held_objects", warning.place) == static_cast<size_t>(fall.object) &&
           warning.frame == fall.frame;
  });
}

bool IsTimeOrLengthWrong(const TimeScale& time) {
  return time.verdict == TimeVerdict::kWrongFrameTime || time.verdict == TimeVerdict::kWrongLength;
}

}  // namespace

FlightAnalysis WithoutGravity(FlightAnalysis analysis,
                              const std::vector<PlacementSpan>& placements) {
  std::erase_if(analysis.flights,
                [&](const Flight& flight) { return IsByGravity(flight, placements); });
  const TimeScale& time = analysis.time;
  analysis.time =
      TimeOf(analysis.flights, time.frame_time, time.stature, time.scale_known, time.true_gravity);
  return analysis;
}

std::optional<int> RateToSet(const TimeScale& time) {
  constexpr double kSame = 0.01;
  if (time.verdict != TimeVerdict::kWrongFrameTime || !time.frame_rate) return std::nullopt;
  if (std::abs(*time.frame_rate * time.frame_time - 1.0) < kSame) return std::nullopt;
  return time.frame_rate;
}

Analyses AnalysesOf(const Animation& animation, const Motion& motion, const Effort& effort,
                    bool size_is_guessed) {
  Analyses analyses;
  analyses.missing = MissingSupports(animation, motion, effort);
  if (motion.rate != animation.rate) return analyses;  // the others are about its frames
  SinkingFinder finder;
  finder.Look(animation, motion, static_cast<int>(motion.frames.size()));
  analyses.sinkings = finder.sinkings();
  MotionSeries series = SeriesOf(*animation.figure, motion);
  series.scale_known = !size_is_guessed;
  const FlightAnalysis flights =
      WithoutGravity(AnalyseFlights(series, animation.gravity), animation.placements);
  analyses.skates = flights.skates;
  analyses.time = flights.time;
  return analyses;
}

std::vector<Finding> FindProblems(const Animation& animation, const Motion& motion,
                                  const Analyses& analyses) {
  std::vector<Finding> findings;
  const auto add = [&](const auto& all) {
    findings.insert(findings.end(), all.begin(), all.end());
  };
  add(motion.placement_jumps);
  for (const Warning& warning : motion.warnings) {
    // Warnings of placements are the jumps.
    if (!IndexIn("placements", warning.place)) findings.emplace_back(warning);
  }
  add(analyses.turns);
  add(analyses.outlasting);
  add(analyses.sinkings);
  for (const FootSkate& skate : analyses.skates) {
    for (const FootSlide& slide : skate.slides) {
      if (slide.distance > kFarSlide) findings.emplace_back(SlidingFoot{skate.foot, slide});
    }
  }
  for (const FallThrough& fall : FallsThrough(animation, motion)) {
    if (!IsWarnedOf(fall, motion)) findings.emplace_back(fall);
  }
  add(ContactJerks(animation, motion));
  add(analyses.missing);
  if (IsTimeOrLengthWrong(analyses.time)) findings.emplace_back(analyses.time);
  return findings;
}

bool IsAWarning(const Finding& finding) {
  return std::holds_alternative<PlacementJump>(finding) ||
         std::holds_alternative<Warning>(finding) || std::holds_alternative<HeldTurn>(finding) ||
         std::holds_alternative<OutlastingConstraint>(finding);
}

std::optional<int> FrameOf(const Finding& finding) {
  struct {
    std::optional<int> operator()(const PlacementJump& jump) const { return jump.frame; }
    std::optional<int> operator()(const Warning& warning) const { return warning.frame; }
    std::optional<int> operator()(const HeldTurn& turn) const { return turn.frame; }
    std::optional<int> operator()(const OutlastingConstraint& own) const { return own.from; }
    std::optional<int> operator()(const Sinking& sinking) const { return sinking.deepest; }
    std::optional<int> operator()(const SlidingFoot& foot) const { return foot.slide.first; }
    std::optional<int> operator()(const FallThrough& fall) const { return fall.frame; }
    std::optional<int> operator()(const ContactJerk& jerk) const { return jerk.frame; }
    std::optional<int> operator()(const MissingSupport& missing) const { return missing.worst; }
    std::optional<int> operator()(const TimeScale&) const { return std::nullopt; }
  } frame;
  return std::visit(frame, finding);
}

}  // namespace hazumi
