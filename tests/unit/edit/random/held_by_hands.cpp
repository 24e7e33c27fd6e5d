#include "tests/unit/edit/random/held_by_hands.h"

#include <algorithm>
#include <cmath>

#include "engine/project/edits/holders.h"

namespace hazumi::test {

using edit::Session;

std::vector<ProjectHeldObject> PassedOn(const Session& session) {
  std::vector<ProjectHeldObject> passed;
  for (const ProjectHeldObject& object : session.project().held_objects) {
    if (!object.holders.empty()) passed.push_back(object);
  }
  return passed;
}

std::vector<ProjectHeldObject> Thrown(const Session& session) {
  const std::vector<ProjectRegion>& regions = session.project().regions;
  std::vector<ProjectHeldObject> thrown;
  for (const ProjectHeldObject& object : session.project().held_objects) {
    const bool is_in_one =
        std::any_of(regions.begin(), regions.end(), [&](const ProjectRegion& region) {
          return object.release_frame > region.first_frame &&
                 object.release_frame <= region.last_frame;
        });
    if (is_in_one) thrown.push_back(object);
  }
  return thrown;
}

std::vector<ProjectHeldObject> InAHand(const Session& session) {
  const Project& project = session.project();
  const int now = static_cast<int>(std::lround(session.frame()));
  std::vector<ProjectHeldObject> held;
  for (const ProjectHeldObject& object : project.held_objects) {
    const std::vector<HolderSpan> spans = HoldersOf(object, project.frames);
    const HolderSpan* holder = HolderAt(now, spans);
    const bool is_hand = holder && (holder->joint == "r_wrist" || holder->joint == "l_wrist");
    if (is_hand && project.regions.empty()) held.push_back(object);
  }
  return held;
}

}  // namespace hazumi::test
