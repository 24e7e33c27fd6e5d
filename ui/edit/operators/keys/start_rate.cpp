// How fast the joints of a dynamics region are let go: the rate of the key on its first frame.

#include <algorithm>

#include "engine/timeline/animation.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// Returns the key on a frame, or a new one with the value that is seen there.
Result<ProjectKey> KeyAtStart(const std::string& hinge, int frame, Session* session) {
  const ProjectCurve* curve = FindCurve(hinge, session->project());
  if (const ProjectKey* key = curve ? KeyOn(frame, *curve) : nullptr) return *key;
  const Result<const Motion*> motion = session->MotionTo(frame);
  if (!motion.ok()) return motion.error();
  const MotionFrame& at = motion.value()->frames[frame - session->project().frames.first];
  ProjectKey key;
  key.frame = frame;
  key.value = ShortestDegrees(at.q[session->figure().FindJoint(hinge)->value()]);
  return key;
}

// The region that was found in the project, as it is animated. Errors: the hinge is not in it, or
// starts as fast as another region leaves it.
Result<const DynamicsRegion*> StartOf(const std::string& hinge, size_t region, Session* session) {
  const Animation* animation = session->animation();
  if (!animation) return session->WholeMotion().error();
  const DynamicsRegion& found = animation->regions[region];
  const auto j = session->figure().FindJoint(hinge);
  if (!j || !std::binary_search(found.joints.begin(), found.joints.end(), *j)) {
    return Refusal("joint", "\"" + hinge + "\" is no hinge of this region");
  }
  if (IsTakenOver(found, *j, *animation)) {
    return Refusal("joint", "\"" + hinge +
                                "\" starts as fast as the region that ends there leaves it; end "
                                "that one earlier");
  }
  return &found;
}

Result<Done> SetStartRate(Session* session, const Parameters& p) {
  std::vector<ProjectRegion> regions = session->project().regions;
  const Result<ProjectRegion*> region = EntryNamed(p.text("region"), "region", &regions);
  if (!region.ok()) return region.error();
  const std::string hinge = p.text("joint");
  const Result<const DynamicsRegion*> start =
      StartOf(hinge, region.value() - regions.data(), session);
  if (!start.ok()) return start.error();
  Result<ProjectKey> key = KeyAtStart(hinge, start.value()->first_frame, session);
  if (!key.ok()) return key.error();
  ProjectKey with_rate = std::move(key).value();
  with_rate.rate = p.number("rate");
  return session->Edit(
      "Set start rate",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectCurve*> curve = CurveNamed(hinge, session->figure(), project);
        if (!curve.ok()) return curve.error();
        PutKey(with_rate, curve.value());
        return Done();
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> StartRateOperators() {
  return {{"region.start_rate",
           "Set start rate",
           "Sets how fast a region lets a joint go: the rate of the key on its first frame, which "
           "is made if there is none.",
           {{"region", kText, true, "the region's name", Thing::kRegion},
            {"joint", kText, true, "a hinge of the region", Thing::kHinge},
            {"rate", kNumber, true, "degrees per second"},
            kDrag},
           SetStartRate}};
}

}  // namespace hazumi::edit
