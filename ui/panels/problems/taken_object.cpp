#include "ui/panels/problems/taken_object.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"

namespace hazumi::ui {

std::optional<Taking> TakingAt(int object, int frame, const Animation& animation,
                               const Motion& motion) {
  const std::vector<Holder>& holders = animation.held_objects[static_cast<size_t>(object)].holders;
  const auto taker = std::find_if(holders.begin(), holders.end(),
                                  [&](const Holder& each) { return each.first_frame == frame; });
  const int i = frame - animation.first_frame;
  if (taker == holders.end() || i < 2 || i >= static_cast<int>(motion.frames.size())) return {};
  const Figure& figure = *animation.figure;
  if (taker == holders.begin() || std::prev(taker)->last_frame != frame) {
    // As between the two frames before.
    const auto place = [&](int before) -> const Vec3& {
      const MotionFrame& there = motion.frames[static_cast<size_t>(i - before)];
      return there.objects[static_cast<size_t>(object)].X_WO.p;
    };
    return Taking{figure.group(taker->joint).name, 2.0 * place(1) - place(2), taker->offset};
  }
  const MotionFrame& now = motion.frames[static_cast<size_t>(i)];
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const Holder& giver = *std::prev(taker);
  const BodyScratch& body = ws.body(figure.group(giver.joint).last());
  return Taking{figure.group(taker->joint).name, body.p + body.R * giver.offset, taker->offset};
}

}  // namespace hazumi::ui
