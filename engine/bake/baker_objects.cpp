// What a bake does with objects where they are let go.

#include "engine/bake/baker.h"
#include "engine/bake/walk/begins_inside.h"

namespace hazumi {

// Of a ball that stays out of the scene, and begins in something of it.
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
