// Release of held objects during a bake.

#include <algorithm>

#include "engine/bake/baker.h"
#include "engine/bake/walk/begins_inside.h"

namespace hazumi {

// Gives an object that is released on the first frame the initial velocity of the figure, from
// keys, regions and pins. No earlier frame defines a velocity there.
std::optional<Error> Baker::ReleaseAsItSetsOut(int frame) {
  const bool takes_it = animation_.solver.rules().releases_at_keyed_speed;
  if (frame != animation_.first_frame || !takes_it) return std::nullopt;
  FigureMotion out = context_.now;
  if (auto error = context_.poses.Evaluate(frame, Side::kAfter, &out)) return error;
  for (const auto& [at, i] : context_.schedule.HandOvers(frame)) {
    const std::vector<Holder>& holders = animation_.held_objects[i].holders;
    const auto by = std::find_if(holders.begin(), holders.end(),
                                 [&](const Holder& h) { return h.last_frame == frame; });
    context_.poses.ReleaseWith(out, static_cast<size_t>(i), static_cast<int>(by - holders.begin()));
  }
  return std::nullopt;
}

// Warns of a ball with contacts that is released inside an object of the scene.
void Baker::WarnIfLetGoInside(int frame, size_t object) {
  const HeldObject& ball = animation_.held_objects[object];
  PoseEvaluator& poses = context_.poses;
  if (!ball.touches_scene) return;
  const Vec3 center = poses.objects().At(object, context_.now, poses.workspace()).X_WO.p;
  const auto inside = TellOfInside(animation_, ball, center, frame);
  if (!inside) return;
  context_.recorder.AddWarning({"held_objects[" + std::to_string(object) + "]", *inside, frame});
}

}  // namespace hazumi
