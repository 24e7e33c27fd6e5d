// What jumps where regions, placements and holds begin and end, against jumps that were made.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/seam_report.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

constexpr double kMass = 3.0, kRadius = 0.05, kLength = 0.8;

std::vector<Seam> SeamsOf(const Animation& animation) {
  BakeOptions options;
  options.seams = true;
  options.keep_frames = false;
  return BakeOrFail(animation, options).seams;
}

const Seam& Find(const std::vector<Seam>& seams, int frame, JointIndex joint = {}) {
  for (const Seam& seam : seams) {
    if (seam.frame == frame && seam.joint == joint) return seam;
  }
  ADD_FAILURE() << "no seam at frame " << frame;
  return seams.front();
}

// A pendulum that arrives at frame 10 with a rate and swings on from there with another one.
Animation Swing(double rate_in, double rate, Method method) {
  Animation animation = Still(Pendulum(kMass, kRadius, kLength));
  animation.solver.method = method;
  animation.solver.tolerance = 1e-9;
  Key at_border{10, 0.5, rate, kCubic};
  at_border.rate_in = rate_in;
  animation.joint_keys[0] = {{0, 0.0, 0.0, kCubic}, at_border, {30, 0.2, 0.0, kCubic}};
  AddRegion(&animation, "swing", 10, 20, {"rod"}, 0.9).method = method;
  return animation;
}

TEST(Seams, OfRatesThatWereMadeAreToldExactly) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    for (const double jump : {0.0, 10.0, 100.0, -100.0}) {
      Animation animation = Swing(1.0, 1.0 + jump * kDegree, method);
      const JointIndex hinge(0);
      const std::vector<Seam> seams = SeamsOf(animation);
      const Seam& seam = Find(seams, 10, hinge);
      EXPECT_NEAR(seam.rate / kDegree, jump, 1e-11);
      EXPECT_EQ(seam.angle, 0.0);
      EXPECT_TRUE(seam.begins);
      EXPECT_EQ(seam.of, SeamOf::kRegion);
      EXPECT_EQ(seam.mend, jump == 0.0 ? SeamMend::kNothing : SeamMend::kKeyRate);
      // The curve goes on as the region left it.
      EXPECT_NEAR(Find(seams, 20, hinge).rate, 0.0, 1e-12);
      EXPECT_EQ(Find(seams, 10).speed, 0.0);
    }
  }
}

double SwingAcceleration(double angle, double rate) {
  const double inertia = kMass * (3.0 * kRadius * kRadius + 4.0 * kLength * kLength) / 12.0;
  return -kMass * kG * 0.5 * kLength * std::sin(angle) / inertia + 30.0 * std::log(0.9) * rate;
}

TEST(Seams, OfAccelerationsAreThoseOfTheCurveAndOfTheSwing) {
  const Animation animation = Swing(1.0, 1.0, Method::kExact);
  const std::vector<Seam> seams = SeamsOf(animation);
  const Motion motion = BakeOrFail(animation);
  // c'' at the end of the cubic from 0 to 0.5 within a third of a second.
  const double T = 1.0 / 3.0, curve = -6.0 * 0.5 / (T * T) + (2.0 * 0.0 + 4.0 * 1.0) / T;
  EXPECT_NEAR(Find(seams, 10, JointIndex(0)).acceleration, SwingAcceleration(0.5, 1.0) - curve,
              1e-9);
  const MotionLimit& end = motion.frames[20].before;
  const double on = 6.0 * (0.2 - end.q[0]) / (T * T) - 4.0 * end.qd[0] / T;
  EXPECT_NEAR(Find(seams, 20, JointIndex(0)).acceleration,
              on - SwingAcceleration(end.q[0], end.qd[0]), 1e-6);
}

TEST(Seams, SayWhatStopsAJointDead) {
  Animation animation = Swing(1.0, 1.0, Method::kExact);
  animation.regions[0].friction = {0.0};
  const std::vector<Seam> frozen = SeamsOf(animation);
  EXPECT_NEAR(Find(frozen, 10, JointIndex(0)).rate, -1.0, 1e-12);
  EXPECT_EQ(Find(frozen, 10, JointIndex(0)).mend, SeamMend::kFriction);
  animation = Swing(1.0, 1.0, Method::kExact);
  animation.joint_keys[0].pop_back();
  const std::vector<Seam> last = SeamsOf(animation);
  const Motion motion = BakeOrFail(animation);
  EXPECT_NEAR(Find(last, 20, JointIndex(0)).rate, -motion.frames[20].before.qd[0], 1e-12);
  EXPECT_EQ(Find(last, 20, JointIndex(0)).mend, SeamMend::kKeyAfter);
}

TEST(Seams, OfAPinThatStopsTheRootAreItsVelocity) {
  Animation animation = Still(Human37());
  animation.root_keys[kRootX] = {{0, 0.0, 2.0, kCubic}, {10, 20.0 / 30.0, 2.0, kCubic}};
  AddPin(&animation, 10, 20, "r_ankle");
  const std::vector<Seam> seams = SeamsOf(animation);
  const Seam& begin = Find(seams, 10);
  EXPECT_NEAR(begin.speed, 2.0, 1e-12);
  EXPECT_NEAR(begin.distance, 0.0, 1e-12);
  EXPECT_EQ(begin.of, SeamOf::kPlacement);
  EXPECT_EQ(begin.mend, SeamMend::kRest);
  const std::vector<std::string> lines = SeamReport(animation, seams);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0],
            "F10 pelvis (placement 0 begins): velocity by 2 m/s; it is to stand still from there "
            "on: let its keys bring it to rest");
}

TEST(Seams, OfAHoldAreTheRatesThatItTakesAway) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_knee_y") = {{0, 0.5, 1.0, kCubic}, {10, 0.8, 1.0, kCubic}};
  KeysOf(&animation, "r_hip_y") = {{0, 0.3, 0.0, kCubic}};
  AddHold(&animation, 10, 20, "r_ankle", false);
  KeyTheRest(&animation);
  const std::vector<Seam> seams = SeamsOf(animation);
  const Seam& knee = Find(seams, 10, JointOf(animation, "r_knee_y"));
  EXPECT_EQ(knee.of, SeamOf::kHold);
  EXPECT_NEAR(knee.rate, -1.0, 1e-9);
  EXPECT_EQ(knee.mend, SeamMend::kRest);
}

// An arm as a ball, an elbow and a wrist: rates at a fine frame rate, differenced.
TEST(Accelerations, AreTheRatesOfTheRates) {
  Animation animation = Still(Human37());
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9;
  KeysOf(&animation, "r_shoulder_y") = {{0, 0.9, 0.0, kCubic}};
  KeysOf(&animation, "r_shoulder_x") = {{0, 0.4, 1.0, kCubic}, {30, 0.0, 0.0, kCubic}};
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 0.8).method = Method::kExact;
  AddPin(&animation, 0, 30, "l_ankle");
  KeysOf(&animation, "l_hip_y") = {{0, 0.0, 0.0, kCubic}, {30, 0.4, 0.0, kCubic}};
  BakeOptions options;
  options.accelerations = true;
  options.output_rate = FrameRate{3000, 1};
  const Motion motion = BakeOrFail(animation, options);
  ASSERT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  double worst = 0.0, largest = 0.0;
  for (size_t i = 1; i + 1 < motion.frames.size(); ++i) {
    ASSERT_TRUE(motion.frames[i].acceleration);
    if (motion.frames[i].frame % 100 == 0) continue;  // pieces of curves may meet there
    const MotionLimit &a = motion.frames[i - 1].after, &b = motion.frames[i + 1].before;
    const VecX found = (b.qd - a.qd) * 1500.0;
    const Vec3 root = (b.root_v - a.root_v) * 1500.0;
    const MotionAcceleration& told = *motion.frames[i].acceleration;
    worst = std::max(
        {worst, (found - told.qdd).lpNorm<Eigen::Infinity>(), (root - told.root_a).norm()});
    largest = std::max(largest, told.qdd.lpNorm<Eigen::Infinity>());
  }
  EXPECT_GT(largest, 5.0);
  EXPECT_LT(worst, 1e-4 * largest);
}

TEST(Accelerations, ChangeNothingElse) {
  const Animation animation = Swing(1.0, 1.5, Method::kExact);
  BakeOptions options;
  options.accelerations = options.seams = true;
  const Motion with = BakeOrFail(animation, options), without = BakeOrFail(animation);
  ASSERT_EQ(with.frames.size(), without.frames.size());
  for (size_t i = 0; i < with.frames.size(); ++i) {
    EXPECT_TRUE(IsSame(with.frames[i], without.frames[i])) << i;
    EXPECT_FALSE(without.frames[i].acceleration);
  }
  EXPECT_EQ(with.regions[0].evaluations, without.regions[0].evaluations);
  EXPECT_TRUE(without.seams.empty());
}

}  // namespace
}  // namespace hazumi::test
