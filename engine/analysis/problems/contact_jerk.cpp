// Horizontally nothing but the ground can push the centre of mass, and the ground no harder than
// the feet grip and the body does not topple: sprinters at the start reach 1 g, long jumpers at
// take-off a few. Its acceleration is the second difference of its places from frame to frame.

#include <algorithm>

#include "engine/analysis/problems/problems.h"

namespace hazumi {

namespace {

constexpr double kMost = 30.0;   // [m/s^2]
constexpr double kBeside = 0.2;  // of the contact [s]

// The hardest in frames first..last, if it is too hard.
void AddHardest(int first, int last, bool is_landing, const Animation& animation,
                const Motion& motion, std::vector<ContactJerk>* jerks) {
  const double second = animation.rate.FrameAt(1.0);
  ContactJerk hardest;
  hardest.is_landing = is_landing;
  const int end = static_cast<int>(motion.frames.size());
  for (int frame = first; frame <= last; ++frame) {
    const int i = frame - animation.first_frame;
    if (i < 1 || i + 1 >= end) continue;
    const Vec3 bend =
        motion.frames[i + 1].com - 2.0 * motion.frames[i].com + motion.frames[i - 1].com;
    const double acceleration = bend.head<2>().norm() * second * second;
    if (acceleration <= hardest.acceleration) continue;
    hardest.acceleration = acceleration;
    hardest.frame = frame;
  }
  if (hardest.acceleration > kMost) jerks->push_back(hardest);
}

}  // namespace

std::vector<ContactJerk> ContactJerks(const Animation& animation, const Motion& motion) {
  std::vector<ContactJerk> jerks;
  const std::vector<PlacementSpan>& spans = animation.placements;
  const int beside = std::max(2, static_cast<int>(animation.rate.FrameAt(kBeside)));
  for (size_t i = 1; i + 1 < spans.size(); ++i) {
    const PlacementSpan &before = spans[i - 1], &flight = spans[i], &after = spans[i + 1];
    if (!LeavesPin(before, flight) || !EndsOnPin(flight, after)) continue;
    const int left = before.last_frame, down = flight.last_frame;
    AddHardest(std::max(before.first_frame, left - beside), left, false, animation, motion, &jerks);
    AddHardest(down, std::min(after.last_frame, down + beside), true, animation, motion, &jerks);
  }
  return jerks;
}

}  // namespace hazumi
