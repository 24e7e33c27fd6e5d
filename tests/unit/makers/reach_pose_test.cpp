// Poses for points, compared with another method from many starts.

#include "engine/makers/aims/reach_pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"

namespace hazumi::test {
namespace {

using makers::Reach;
using makers::ReachFor;
using makers::ReachHinge;

const Vec3 kPalm(0.0, 0.0, -0.1);  // in the frame of the wrist [m]

std::vector<ReachHinge> RightArm() {
  const Figure figure =
      BuildFigure(LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value()).value();
  std::vector<ReachHinge> hinges;
  const int first = figure.FindJoint("r_shoulder_flexion")->value();
  for (int j = first; j < figure.joint(JointIndex(first)).subtree_end.value(); ++j) {
    const Joint& joint = figure.joint(JointIndex(j));
    hinges.push_back({joint.X_PJ, joint.axis, joint.lower, joint.upper, joint.rest, joint.rest});
  }
  return hinges;
}

Vec3 PalmAt(const std::vector<ReachHinge>& hinges, const VecX& q) {
  Pose at;
  for (size_t k = 0; k < hinges.size(); ++k) {
    at = at * hinges[k].X_PJ;
    at.R *= Eigen::AngleAxisd(q[static_cast<int>(k)], hinges[k].axis).toRotationMatrix();
  }
  return at * kPalm;
}

// Turns one hinge after the other as near to the place as it can.
double ByCyclicDescent(const std::vector<ReachHinge>& hinges, const Vec3& place, VecX q) {
  for (int sweep = 0; sweep < 10; ++sweep) {
    for (size_t k = hinges.size(); k-- > 0;) {
      Pose at;
      for (size_t i = 0; i <= k; ++i) {
        at = at * hinges[i].X_PJ;
        if (i < k)
          at.R *= Eigen::AngleAxisd(q[static_cast<int>(i)], hinges[i].axis).toRotationMatrix();
      }
      const Vec3 axis = at.R * hinges[k].axis;
      const auto across = [&](const Vec3& p) -> Vec3 {
        const Vec3 d = p - at.p;
        return d - axis * axis.dot(d);
      };
      const Vec3 from = across(PalmAt(hinges, q)), to = across(place);
      const double turn = std::atan2(axis.dot(from.cross(to)), from.dot(to));
      double& angle = q[static_cast<int>(k)];
      angle = std::clamp(angle + turn, hinges[k].lower, hinges[k].upper);
    }
  }
  return (PalmAt(hinges, q) - place).norm();
}

TEST(ReachFor, ComesAsNearAsTheBestOfFiftyStartsOfAnotherMethod) {
  const std::vector<ReachHinge> hinges = RightArm();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0), place(-1.0, 1.0);
  int out_of_reach = 0, reached = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 target = 0.6 * Vec3(place(random), place(random), place(random));
    const Reach reach = ReachFor(Pose(), hinges, kPalm, target);
    for (size_t k = 0; k < hinges.size(); ++k) {
      EXPECT_GE(reach.angles[static_cast<int>(k)], hinges[k].lower);
      EXPECT_LE(reach.angles[static_cast<int>(k)], hinges[k].upper);
    }
    EXPECT_NEAR(reach.distance, (PalmAt(hinges, reach.angles) - target).norm(), 1e-12);
    double best = reach.distance;
    for (int start = 0; start < 50; ++start) {
      VecX q(static_cast<int>(hinges.size()));
      for (size_t k = 0; k < hinges.size(); ++k) {
        q[static_cast<int>(k)] =
            hinges[k].lower + share(random) * (hinges[k].upper - hinges[k].lower);
      }
      best = std::min(best, ByCyclicDescent(hinges, target, q));
    }
    EXPECT_LT(reach.distance, std::max(1.1 * best, 1e-4)) << i << ": " << best;
    ++(reach.distance > 1e-3 ? out_of_reach : reached);
  }
  EXPECT_GE(out_of_reach, 20);
  EXPECT_GE(reached, 10);
}

}  // namespace
}  // namespace hazumi::test
