#include "tests/unit/bake/loose_human.h"

#include "engine/project/figure_file.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {

namespace {

FigureSpec ShippedHumanSpec() {
  return LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value();
}

}  // namespace

Figure LimberHuman() {
  FigureSpec spec = ShippedHumanSpec();
  for (JointSpec& joint : spec.joints) {
    for (HingeSpec& hinge : joint.hinges) {
      hinge.lower = -1000.0;
      hinge.upper = 1000.0;
    }
  }
  return Build(spec);
}

Animation LooseHuman(int frames, double height, double tilt) {
  Animation animation = Still(Build(ShippedHumanSpec()));
  animation.solver.method = Method::kExact;
  animation.gravity = kG;
  animation.last_frame = frames;
  AddGravity(&animation, 0, frames);
  AddFloor(&animation);
  DynamicsRegion region;
  region.name = "all";
  region.method = Method::kExact;
  region.last_frame = frames;
  region.root = region.touches_scene = true;
  for (int j = 0; j < animation.figure->num_joints(); ++j) region.joints.emplace_back(j);
  region.friction.assign(region.joints.size(), 0.8);
  animation.regions.push_back(region);
  animation.root_keys[2] = {{0, height, 0.0, Interpolation::kHold}};
  animation.root_keys[4] = {{0, tilt, 0.0, Interpolation::kHold}};
  return animation;
}

}  // namespace hazumi::test
