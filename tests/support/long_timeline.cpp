#include "tests/support/long_timeline.h"

#include <algorithm>
#include <cmath>

#include "engine/project/figure_file.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {

namespace {

constexpr int kKeyStep = 10;       // frames
constexpr int kRegionLength = 10;  // frames

// Every hinge but those of the feet sways a little, each in its own time.
void KeyJoints(int num_frames, Animation* animation) {
  const Figure& figure = *animation->figure;
  for (int j = 0; j < figure.num_joints(); ++j) {
    const Joint& joint = figure.joints()[j];
    const double size = 0.1 * (joint.upper - joint.lower);
    for (int frame = 0; frame <= num_frames; frame += kKeyStep) {
      const double angle = joint.rest + size * std::sin(0.07 * (frame + 13 * j));
      animation->joint_keys[j].push_back(
          {double(frame), std::clamp(angle, joint.lower, joint.upper), {}, Interpolation::kCubic});
    }
  }
}

}  // namespace

Animation LongTimeline(int num_frames, int num_regions) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/figures/human.json";
  Animation animation = Still(Build(LoadFigure(path).value()));
  animation.last_frame = num_frames;
  animation.solver.method = Method::kExact;
  KeyJoints(num_frames, &animation);
  const int pace = num_frames / num_regions;
  for (int r = 0; r < num_regions; ++r) {
    const int first = r * pace;
    AddRegion(&animation, "arms", first + kKeyStep, first + kKeyStep + kRegionLength,
              {"l_shoulder", "r_shoulder"}, 0.9)
        .method = Method::kExact;
    AddPin(&animation, first, first + pace, r % 2 == 0 ? "l_toe" : "r_toe");
  }
  return animation;
}

}  // namespace hazumi::test
