// What the shipped examples must do, where reading the frames of a bake is not enough.

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/spatial/degrees.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;

Compiled Load(const std::string& name) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/" + name + ".kfa";
  const Result<Project> project = LoadProject(path);
  EXPECT_TRUE(project.ok()) << project.error().ToString();
  Result<Compiled> compiled = CompileAnimation(project.value());
  EXPECT_TRUE(compiled.ok()) << compiled.error().ToString();
  return std::move(compiled).value();
}

Motion BakeExample(const std::string& name) { return Bake(Load(name).animation).value(); }

double LargestJump(const MotionLimit& before, const MotionLimit& after) {
  return std::max({(before.q - after.q).cwiseAbs().maxCoeff(),
                   (before.qd - after.qd).cwiseAbs().maxCoeff(),
                   (before.X_WR.p - after.X_WR.p).norm(), (before.X_WR.R - after.X_WR.R).norm(),
                   (before.root_v - after.root_v).norm(), (before.root_w - after.root_w).norm()});
}

// A region that starts with a rate of its own may break the rates of its joints; nothing else may.
TEST(Throw, EverythingIsContinuousWhereTheRegionAndThePinBegin) {
  const MotionFrame frame = BakeExample("throw").frames[5];
  EXPECT_LT(LargestJump(frame.before, frame.after), 1e-9);
}

TEST(Throw, EverythingIsContinuousWhereTheRegionEnds) {
  const MotionFrame frame = BakeExample("throw").frames[15];
  EXPECT_LT(LargestJump(frame.before, frame.after), 1e-9);
}

// The recorded rates are the derivatives of the recorded motion: seen at 3000 frames a second, on
// both sides of F5 and of F15, where curves rule.
TEST(Throw, RatesAreTheDerivativesOfTheMotion) {
  const Compiled compiled = Load("throw");
  const Motion motion = Bake(compiled.animation).value();
  const Motion dense = Bake(compiled.animation, {FrameRate{3000, 1}}).value();
  const double h = 1.0 / 3000;
  const VecX before = (dense.frames[500].after.q - dense.frames[499].after.q) / h;
  const VecX after = (dense.frames[1501].after.q - dense.frames[1500].after.q) / h;
  EXPECT_LT((before - motion.frames[5].before.qd).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT((after - motion.frames[15].after.qd).cwiseAbs().maxCoeff(), 0.1);
}

TEST(Throw, TheBallFliesOnAParabolaFromTheVelocityOfTheHand) {
  const Compiled compiled = Load("throw");
  const Motion motion = Bake(compiled.animation).value();
  const int release = *compiled.animation.held_objects[0].holders[0].last_frame;
  const Vec3 p0 = motion.frames[release].objects[0].X_WO.p;
  const Vec3 p1 = motion.frames[release + 1].objects[0].X_WO.p;
  const double t = compiled.animation.rate.seconds_per_frame();
  const Vec3 g(0.0, 0.0, -9.81);
  const Vec3 v = (p1 - p0) / t - 0.5 * g * t;
  for (int i = 0; release + i < 31; ++i) {
    const Vec3 expected = p0 + v * (i * t) + 0.5 * g * (i * t) * (i * t);
    EXPECT_LT((motion.frames[release + i].objects[0].X_WO.p - expected).norm(), 1e-12);
  }
}

// But for what the curl is about: a weight that one of both elbows cannot lift.
TEST(Examples, CompileAndBakeWithoutAWarning) {
  for (const auto& entry : fs::directory_iterator(HAZUMI_SOURCE_DIR "/assets/examples")) {
    if (entry.path().extension() != ".kfa") continue;
    const Compiled compiled = Load(entry.path().stem().string());
    for (const Warning& warning : compiled.warnings) ADD_FAILURE() << warning.message;
    const Motion motion = Bake(compiled.animation).value();
    int too_weak = 0;
    for (const Warning& warning : motion.warnings) {
      if (entry.path().stem() == "curl" &&
          warning.message.starts_with("the spring of \"l_elbow_flexion\" is too weak")) {
        ++too_weak;
        continue;
      }
      ADD_FAILURE() << warning.place << ": " << warning.message;
    }
    EXPECT_EQ(too_weak, entry.path().stem() == "curl" ? 1 : 0);
  }
}

// Arms on a prescribed trunk do not feel each other, so one region for both is two regions.
TEST(Throw, OneRegionForBothArmsEqualsARegionForEach) {
  Compiled compiled = Load("throw");
  const Motion together = Bake(compiled.animation).value();
  DynamicsRegion& both = compiled.animation.regions[0];
  DynamicsRegion left = both, right = both;
  const size_t half = both.joints.size() / 2;
  left.joints.resize(half);
  left.friction.resize(half);
  right.joints.erase(right.joints.begin(), right.joints.begin() + half);
  right.friction.erase(right.friction.begin(), right.friction.begin() + half);
  compiled.animation.regions = {left, right};
  const Motion apart = Bake(compiled.animation).value();
  for (size_t i = 0; i < together.frames.size(); ++i) {
    EXPECT_LT((together.frames[i].after.q - apart.frames[i].after.q).cwiseAbs().maxCoeff(), 1e-9);
  }
}

double LastAngle(const Motion& motion, const Figure& figure, const char* hinge) {
  return motion.frames.back().q[figure.FindJoint(hinge)->value()] / kDegree;
}

TEST(Curl, TheLightWeightGetsUpAndTheHeavyOneDoesNot) {
  const Compiled compiled = Load("curl");
  const Figure& figure = *compiled.animation.figure;
  const Motion motion = Bake(compiled.animation).value();
  EXPECT_GT(LastAngle(motion, figure, "r_elbow_flexion"), 115.0);  // of 125
  EXPECT_LT(LastAngle(motion, figure, "l_elbow_flexion"), 70.0);
}

// Thrown back by the push, and back in the pose of the keys two seconds later.
TEST(Blow, TheUpperBodyIsThrownBackAndComesBack) {
  const Compiled compiled = Load("blow");
  const Figure& figure = *compiled.animation.figure;
  const Motion motion = Bake(compiled.animation).value();
  const JointIndex chest = *figure.FindJoint("chest_flexion");
  double least = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    least = std::min(least, frame.q[chest.value()] / kDegree);
  }
  EXPECT_LT(least, -5.0);
  EXPECT_NEAR(LastAngle(motion, figure, "chest_flexion"), 0.0, 3.0);
  EXPECT_NEAR(LastAngle(motion, figure, "r_elbow_flexion"), 25.0, 10.0);
}

}  // namespace
}  // namespace hazumi
