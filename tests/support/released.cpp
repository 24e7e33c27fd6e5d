#include "tests/support/released.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/energy.h"

namespace hazumi::test {

Animation Released(Figure figure, const VecX& q, const VecX& qd, int frames, Method method) {
  Animation animation = Still(std::move(figure));
  animation.last_frame = frames;
  DynamicsRegion region;
  region.name = "all";
  region.last_frame = frames;
  for (int j = 0; j < animation.figure->num_joints(); ++j) {
    animation.joint_keys[j] = {{0.0, q[j], qd[j], Interpolation::kCubic}};
    region.joints.emplace_back(j);
  }
  region.friction.assign(region.joints.size(), 1.0);
  animation.regions = {region};
  SetMethod(&animation, method);
  return animation;
}

void SetMethod(Animation* animation, Method method) {
  animation->solver.method = method;
  for (DynamicsRegion& region : animation->regions) region.method = method;
}

void SetTolerance(Animation* animation, double radians) { animation->solver.tolerance = radians; }

void SetStep(Animation* animation, double seconds) { animation->solver.step = seconds; }

namespace {

bool IsFinite(const MotionLimit& limit) {
  return limit.q.allFinite() && limit.qd.allFinite() && limit.X_WR.R.allFinite() &&
         limit.X_WR.p.allFinite() && limit.root_w.allFinite() && limit.root_v.allFinite();
}

bool IsFinite(const MotionFrame& frame) {
  return frame.q.allFinite() && frame.X_WR.R.allFinite() && frame.X_WR.p.allFinite() &&
         IsFinite(frame.before) && IsFinite(frame.after) && frame.com.allFinite();
}

}  // namespace

bool IsFinite(const Motion& motion) {
  return std::all_of(motion.frames.begin(), motion.frames.end(),
                     [](const MotionFrame& frame) { return IsFinite(frame); }) &&
         std::all_of(motion.events.begin(), motion.events.end(),
                     [](const MotionEvent& event) { return std::isfinite(event.time); });
}

bool SaysJointFrameAndCause(const Error& error) {
  const auto says = [&](const char* word) { return error.message.find(word) != std::string::npos; };
  // "... after frame 3: joint "elbow": its rate grows without bound; try a smaller step"
  return error.code == ErrorCode::kSemantics && says("after frame ") && says("joint \"") &&
         says("\": ");
}

namespace {

long EvaluationsOf(const Motion& motion) {
  long sum = 0;
  for (const RegionReport& report : motion.regions) sum += report.evaluations;
  return sum;
}

}  // namespace

Result<Motion> BakeSoundly(const Animation& animation) {
  constexpr long kMostEvaluations = 1'000'000;
  Result<Motion> motion = Bake(animation);
  if (motion.ok()) {
    EXPECT_LE(EvaluationsOf(motion.value()), kMostEvaluations);
    EXPECT_TRUE(IsFinite(motion.value()));
    EXPECT_EQ(motion.value().frames.size(), animation.last_frame - animation.first_frame + 1u);
  } else {
    EXPECT_TRUE(SaysJointFrameAndCause(motion.error())) << motion.error().ToString();
  }
  return motion;
}

Motion BakeFinite(const Animation& animation) {
  Result<Motion> motion = BakeSoundly(animation);
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return motion.ok() ? std::move(motion).value() : Motion();
}

double EnergyGain(const Animation& animation, const Motion& motion) {
  const Figure& figure = *animation.figure;
  const MotionLimit &first = motion.frames.front().after, &last = motion.frames.back().before;
  const double scale = EnergyScale(figure, first.q, first.qd, animation.gravity);
  return (EnergyOf(figure, last, animation.gravity) - EnergyOf(figure, first, animation.gravity)) /
         scale;
}

}  // namespace hazumi::test
