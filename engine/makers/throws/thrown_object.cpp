#include "engine/makers/throws/thrown_object.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hazumi::makers {

namespace {

// Keys that it has from this frame on, until the next one has it.
void ClearFlight(int release, ProjectHeldObject* object) {
  double until = std::numeric_limits<double>::infinity();
  for (const ProjectHolder& holder : object->holders) {
    if (holder.first_frame > release) until = std::min<double>(until, holder.first_frame);
  }
  for (ProjectCurve& curve : object->position.curves) {
    std::erase_if(curve.keys,
                  [&](const ProjectKey& key) { return key.frame >= release && key.frame < until; });
  }
}

// Lets an object that lies somewhere lie there until a holder takes it. Otherwise it would begin to
// move to where it lies next.
void LieUntilTaken(int holder, int taken, ProjectHeldObject* object) {
  if (holder < 0) return;
  for (ProjectCurve& curve : object->position.curves) {
    ProjectKey* last = nullptr;
    for (ProjectKey& key : curve.keys) {
      if (key.frame <= taken) last = &key;
    }
    if (last) last->interpolation = Interpolation::kHold;
  }
}

}  // namespace

int LieDown(const ThrowPath& path, const Vec3& spot, const HolderSpan& thrower,
            const Animation& animation, int object, Project* project) {
  constexpr double kSeenLying = 0.6;  // [s]
  ProjectHeldObject* const thrown = &project->held_objects[static_cast<size_t>(object)];
  const int release = thrower.last;
  ClearFlight(release, thrown);
  LieUntilTaken(thrower.number, thrower.first, thrown);
  const double flown = animation.rate.FrameAt(path.seconds);
  const int down = release + std::max(1, static_cast<int>(std::ceil(flown)));
  PutPosition(spot, down, thrown);
  for (size_t i = 0; i < thrown->holders.size(); ++i) {
    LieUntilTaken(static_cast<int>(i), thrown->holders[i].first_frame, thrown);
  }
  const int seen = down + static_cast<int>(std::lround(animation.rate.FrameAt(kSeenLying)));
  project->frames.last = std::max(project->frames.last, seen);
  return down;
}

}  // namespace hazumi::makers
