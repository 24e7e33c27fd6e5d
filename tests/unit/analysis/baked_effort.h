#pragma once

#include "engine/analysis/effort.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "tests/support/animations.h"

namespace hazumi::test {

// A motion, and what it asks of muscles.
struct BakedEffort {
  Motion motion;
  Effort effort;
};

inline BakedEffort BakeEffort(const Animation& animation,
                              std::optional<FrameRate> rate = std::nullopt) {
  BakeOptions options;
  options.accelerations = true;
  options.output_rate = rate;
  BakedEffort found{BakeOrFail(animation, options), {}};
  found.effort = EffortOf(animation, found.motion);
  return found;
}

inline constexpr double kHipHeight = 0.9024;  // root height of the shipped human [m]

inline Figure ShippedHuman() {
  return BuildFigure(LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value()).value();
}

inline Animation Standing() {
  Animation animation = Still(ShippedHuman());
  animation.root_keys[kRootZ] = {{0, kHipHeight, 0.0, kCubic}};
  AddFloor(&animation);
  return animation;
}

// Sum of all contact forces on the leg of one side [N].
inline Vec3 LegForce(const Animation& animation, const FrameEffort& frame, const char* side) {
  Vec3 sum = Vec3::Zero();
  for (const EffortContact& contact : frame.contacts) {
    const std::string& name = animation.figure->joint(contact.joint).name;
    if (name.starts_with(side)) sum += contact.force;
  }
  return sum;
}

inline Vec3 SumOfContacts(const FrameEffort& frame) {
  Vec3 sum = Vec3::Zero();
  for (const EffortContact& contact : frame.contacts) sum += contact.force;
  return sum;
}

}  // namespace hazumi::test
