// The root on its way from one placement to the next [METHOD 5.8]: a fall takes its velocity from
// keys or curves; behind a placement the curves go on from where the figure is; what jumps, or has
// far to go, is warned of.

#include "engine/bake/handover/placement_handover.h"

#include <algorithm>

#include "engine/base/text.h"

namespace hazumi {

bool PlacementHandover::End(int frame) {
  PoseEvaluator& poses = context_.poses;
  if (!poses.span() || poses.span()->last_frame != frame) return false;
  if (!poses.placement().is_keyed()) {
    WarnOfDistance(frame);
    const FigureMotion& now = context_.now;
    for (int i = 0; i < 3; ++i) {
      poses.curves().root(kRootX + i).Resume(frame, now.X_WR.p[i], now.root.v[i]);
    }
  }
  poses.StartPlacement(nullptr);
  return true;
}

bool PlacementHandover::Begin(int frame, bool was_keyed) {
  const PlacementSpan* span = context_.schedule.PlacementFrom(frame);
  if (!span) return false;
  RootPlacement& placement = context_.poses.StartPlacement(span);
  if (placement.is_ballistic() && was_keyed) TakeKeyedVelocity(frame);
  placement.Begin(context_.Seconds(frame), context_.now);
  if (const auto pin = placement.pin()) {
    context_.recorder.AddEvent(EventKind::kPinChange, frame, context_.NameOf(*pin));
  }
  return true;
}

// A fall takes the figure over as a region takes a joint over: with the root's rates given by keys
// on its first frame, else with those that the curves before it left. Before the animation's first
// frame there is nothing, so all curves start as their keys say.
void PlacementHandover::TakeKeyedVelocity(int frame) {
  PoseEvaluator& poses = context_.poses;
  FigureMotion& now = context_.now;
  if (frame == context_.animation.first_frame) {
    poses.SetJoints(frame, Side::kAfter, &now);
    poses.TurnRoot(frame, Side::kAfter, &now);
    poses.curves().SampleRootPosition(frame, Side::kAfter, &now);
  }
  for (int i = 0; i < 3; ++i) {
    const Key* key = poses.curves().root(kRootX + i).KeyAt(frame);
    if (key && key->rate) now.root.v[i] = *key->rate;
  }
}

void PlacementHandover::WarnOfVelocityJump(int frame) {
  constexpr double kJump = 0.01;  // [m/s]; at 30 frames a second it is a third of a millimetre
  const double jump = (context_.now.root.v - context_.before.root_v).norm();
  if (frame == context_.animation.first_frame || jump <= kJump) return;
  context_.recorder.AddJump({context_.schedule.PlacementAt(frame), frame, jump},
                            "the root's velocity jumps by " + FormatShort(jump) + " m/s at frame " +
                                std::to_string(frame) + ", where the placement changes");
}

// A figure that is not where the keys beyond the placement have it gets there by the next one.
void PlacementHandover::WarnOfDistance(int frame) {
  constexpr double kFar = 0.01, kFast = 0.25;  // [m], [m/s]
  constexpr double kNext = 1e-9;               // [frames]
  Vec3 way = Vec3::Zero();
  double seconds = 0.0;
  for (int i = 0; i < 3; ++i) {
    CurveTrack& curve = context_.poses.curves().root(kRootX + i);
    if (!curve.HasKeyAfter(frame)) continue;
    const double until = context_.Seconds(curve.BlendTarget(frame + kNext).frame - frame);
    way[i] = curve.At(frame).value - context_.now.X_WR.p[i];
    seconds = seconds > 0.0 ? std::min(seconds, until) : until;
  }
  if (way.norm() <= kFar || way.norm() <= kFast * seconds) return;
  const auto index = context_.poses.span() - context_.animation.placements.data();
  context_.recorder.AddJump(
      {static_cast<int>(index), frame, 0.0, way.norm(), seconds},
      "at frame " + std::to_string(frame) + ", where the placement ends, the root is " +
          FormatShort(way.norm()) + " m from where its keys have it; it gets there within " +
          FormatShort(seconds) + " s");
}

}  // namespace hazumi
