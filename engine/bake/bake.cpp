#include "engine/bake/bake.h"

#include <algorithm>

#include "engine/bake/baker.h"

namespace hazumi {

Result<Motion> Bake(const Animation& animation, const BakeOptions& options) {
  const auto falls = [](const PlacementSpan& span) { return span.kind == PlacementKind::kGravity; };
  const auto& spans = animation.placements;
  const auto span = std::find_if(spans.begin(), spans.end(), falls);
  if (span != spans.end() && animation.figure->groups().empty()) {
    return Error{ErrorCode::kSemantics, "",
                 "placements[" + std::to_string(span - spans.begin()) + "]",
                 "the figure has no joint that could be pinned where it lands; give it one"};
  }
  Motion motion;
  Team team(options.threads);
  Baker baker(animation, options, &motion, &team);
  Result<Checkpoint> first = baker.Begin();
  if (!first.ok()) return first.error();
  Stretch stretch;
  stretch.start = std::move(first.value());
  for (;;) {
    Result<std::optional<Checkpoint>> next = baker.BakeStretch({}, &stretch);
    if (!next.ok()) return next.error();
    stretch.AppendTo(&motion);
    if (!next.value()) break;
    stretch.start = std::move(*next.value());
  }
  SortByTime(&motion.events);
  return motion;
}

}  // namespace hazumi
