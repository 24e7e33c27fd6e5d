#include "engine/bake/bake.h"

#include <algorithm>

#include "engine/bake/bake_size.h"
#include "engine/bake/baker.h"
#include "engine/bake/flight_events.h"
#include "engine/base/memory.h"

namespace hazumi {

namespace {

std::optional<Error> CheckSize(const Animation& animation, const BakeOptions& options) {
  if (auto error = CheckSteps(animation)) return error;
  if (!options.keep_frames) return std::nullopt;
  const FrameRate rate = options.output_rate.value_or(animation.rate);
  return CheckBytes(MotionBytes(animation, rate), animation, rate);
}

Result<Motion> BakeWhole(const Animation& animation, const BakeOptions& options) {
  if (auto error = CheckSize(animation, options)) return *error;
  const auto falls = [](const PlacementSpan& span) { return span.kind == PlacementKind::kGravity; };
  const auto& spans = animation.placements;
  const auto span = std::find_if(spans.begin(), spans.end(), falls);
  if (span != spans.end() && animation.figure->groups().empty()) {
    return Error{ErrorCode::kSemantics, "",
                 "placements[" + std::to_string(span - spans.begin()) + "]",
                 "the figure has no joint that could be pinned where it lands; give it one"};
  }
  Motion motion;
  ThreadPool pool(options.threads);
  Baker baker(animation, options, &motion, &pool);
  Result<Checkpoint> first = baker.Begin();
  if (!first.ok()) return first.error();
  Stretch stretch;
  stretch.start = std::move(first.value());
  for (;;) {
    Result<std::optional<Checkpoint>> next = baker.BakeStretch(nullptr, &stretch);
    if (!next.ok() && !baker.ended_early()) return next.error();
    stretch.AppendTo(&motion);
    if (!next.ok() || !next.value()) break;
    stretch.start = std::move(*next.value());
  }
  const std::optional<Warning> ended_early = baker.EndEarly();
  TellFlights(animation, &motion);
  if (ended_early) motion.warnings.push_back(*ended_early);
  DropRepeated(&motion.warnings);
  return motion;
}

}  // namespace

Result<Motion> Bake(const Animation& animation, const BakeOptions& options) {
  return WithinMemory([&] { return BakeWhole(animation, options); });
}

}  // namespace hazumi
