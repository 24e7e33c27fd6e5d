// Loops that point constraints close, beside Simbody with its ball constraints.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/bench/simbody_bodies.h"
#include "tests/support/compare.h"
#include "tests/unit/bake/loops.h"

namespace hazumi::test {
namespace {

using bench::SimbodyTree;

// All of a figure on a root that stays where the world's origin is.
class SimbodyLoop {
 public:
  explicit SimbodyLoop(const Animation& animation)
      : figure_(*animation.figure),
        signs_(bench::CoordinateSigns(figure_, bench::Threes::kHinges)),
        tree_(bench::SimbodyBodies(figure_, bench::Threes::kHinges), animation.gravity,
              TiesOf(animation)) {}

  // The angles `seconds` after a frame's state.
  VecX AnglesAfter(const MotionFrame& start, double seconds) {
    tree_.SetState(signs_.cwiseProduct(start.q), signs_.cwiseProduct(start.after.qd));
    tree_.Integrate(bench::SimbodyIntegrator::kMerson, 1e-11, seconds);
    return signs_.cwiseProduct(tree_.EndCoordinates());
  }

 private:
  static std::vector<SimbodyTree::Tie> TiesOf(const Animation& animation) {
    std::vector<SimbodyTree::Tie> ties;
    for (const Constraint& held : animation.constraints) {
      ties.push_back({held.a.joint->value(), held.a.offset, -1, held.b.offset});
    }
    return ties;
  }

  const Figure& figure_;
  VecX signs_;
  SimbodyTree tree_;
};

// Two arms on a base that stays, both hands held where they are, limbs that turn as they like.
Animation ArmsOnABar(int frames) {
  FigureSpec spec = Arm7Spec();
  for (JointSpec& joint : spec.joints) {
    for (HingeSpec& hinge : joint.hinges) {
      hinge.lower = -1e3;
      hinge.upper = 1e3;
    }
  }
  const std::vector<JointSpec> right = spec.joints;
  for (const JointSpec& joint : right) {
    JointSpec twin = joint;
    twin.name[0] = 'l';
    if (twin.parent == spec.root_name) {
      twin.offset.y() += 0.36;
    } else {
      twin.parent[0] = 'l';
    }
    for (LinkSpec& link : twin.links) link.name[0] = 'l';
    spec.joints.push_back(twin);
  }
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  animation.last_frame = frames;
  for (const std::string side : {"l", "r"}) {
    KeysOf(&animation, (side + "_shoulder_y").c_str()) = {{0, -1.3, 0.0, kHold}};
    KeysOf(&animation,
           (side + "_shoulder_x").c_str()) = {{0, side == "l" ? 0.3 : -0.4, 0.0, kHold}};
    KeysOf(&animation, (side + "_elbow_y").c_str()) = {{0, -0.9, 0.0, kHold}};
    KeysOf(&animation, (side + "_elbow_z").c_str()) = {{0, side == "l" ? 0.2 : -0.1, 0.0, kHold}};
  }
  const Motion still = BakeOrFail(animation);
  AddRegion(&animation, "arms", 0, frames, {"l_shoulder", "r_shoulder"}).method = Method::kExact;
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, still.frames[0].X_WR, still.frames[0].q, &ws);
  for (const char* joint : {"l_wrist", "r_wrist"}) {
    ConstraintEnd hand = OnJoint(animation, joint);
    hand.offset = Vec3(0.0, 0.0, -0.09);
    const BodyScratch& body = ws.body(animation.figure->group(*hand.joint).last());
    AddPoint(&animation, hand, InWorld(body.p + body.R * hand.offset), 0, frames);
  }
  return animation;
}

void ExpectAsSimbody(const Animation& animation, const char* claim) {
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  SimbodyLoop simbody(animation);
  Worst worst(claim);
  double moved = 0.0;
  for (int frame = 6; frame <= animation.last_frame; frame += 6) {
    const VecX angles = simbody.AnglesAfter(motion.frames[0], frame / 30.0);
    worst((motion.frames[frame].before.q - angles).lpNorm<Eigen::Infinity>());
    moved = std::max(moved, (angles - motion.frames[0].q).lpNorm<Eigen::Infinity>());
  }
  std::printf("  %s: %.2g rad, of up to %.1f that joints turn\n", claim, worst.value(), moved);
  EXPECT_LT(worst.value(), 1e-5) << claim;
  EXPECT_GT(moved, 0.3) << claim;
}

TEST(LoopsBesideSimbody, AFourBarSwings) { ExpectAsSimbody(FourBar(60), "four bars"); }

TEST(LoopsBesideSimbody, BothHandsOnABar) { ExpectAsSimbody(ArmsOnABar(30), "hands on a bar"); }

}  // namespace
}  // namespace hazumi::test
