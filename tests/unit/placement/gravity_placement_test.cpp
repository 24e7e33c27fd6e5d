#include "engine/placement/gravity_placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/timeline/interval.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

constexpr double kG = 9.81;
using Kind = GravityPlacement::EventKind;

// Angle, rate and acceleration of the knee, or of any one joint, over time.
using Script = std::function<CurveSample(double)>;
CurveSample AtRest(double) { return {}; }

// A figure that stands upright, one joint of which moves by a script.
class Fall {
 public:
  Fall(Figure figure, std::vector<SceneObject> scene, const char* moving = "foot",
       Script script = AtRest)
      : figure_(std::move(figure)),
        scene_(std::move(scene)),
        moving_(*figure_.FindJoint(moving)),
        script_(std::move(script)),
        ws_(figure_) {
    now_.q = now_.qd = now_.qdd = VecX::Zero(figure_.num_joints());
  }

  PlacementSpan span{PlacementKind::kGravity, 0, 100, {}, {}};

  void Start(const Vec3& p, const Vec3& v) {
    Pose(0.0, &now_);
    now_.X_WR.p = p;
    now_.root.v = v;
    gravity_.emplace(figure_, scene_, span, kG);
    gravity_->Start(now_, &ws_);
    gravity_->Place(&ws_, &now_);
  }

  void Step(double dt) {
    FigureMotion next = now_;
    Pose(time_ + dt, &next);
    gravity_->Advance(now_, dt, &ws_, &next);
    for (const auto& event : gravity_->events()) {
      events.push_back({event.kind, time_ + event.seconds_into_step});
    }
    time_ += dt;
    gravity_->Place(&ws_, &next);
    now_ = next;
  }
  void Run(int steps, double dt) {
    for (int i = 0; i < steps; ++i) Step(dt);
  }

  Vec3 com() {
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    return CenterOfMass(figure_, ws_);
  }
  double clearance() {
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    return NearestContact(figure_, scene_, ws_)->clearance;
  }
  std::string pin() const {
    return gravity_->pin() ? figure_.group(*gravity_->pin()).name : "none";
  }
  Vec3 pin_now() {
    ComputePositions(figure_, now_.X_WR, now_.q, &ws_);
    return ws_.body(figure_.group(*gravity_->pin()).first).p;
  }
  void PlaceEarlier(double seconds, FigureMotion* motion) {
    gravity_->Place(&ws_, motion, seconds);
  }
  GroupIndex group(const char* name) const { return *figure_.FindGroup(name); }
  const FigureMotion& now() const { return now_; }
  double time() const { return time_; }
  // Time of the only event of a kind, NaN if it is not the only one.
  double TimeOf(Kind kind) const {
    double time = std::nan("");
    int count = 0;
    for (const auto& event : events) {
      if (event.kind == kind) time = event.time, ++count;
    }
    return count == 1 ? time : std::nan("");
  }

  struct Event {
    Kind kind;
    double time;
  };
  std::vector<Event> events;

 private:
  void Pose(double t, FigureMotion* motion) const {
    const CurveSample sample = script_(t);
    motion->q[moving_.value()] = sample.value;
    motion->qd[moving_.value()] = sample.rate;
    motion->qdd[moving_.value()] = sample.acceleration;
  }

  Figure figure_;
  std::vector<SceneObject> scene_;
  JointIndex moving_;
  Script script_;
  DynamicsWorkspace ws_;
  FigureMotion now_;
  double time_ = 0.0;
  std::optional<GravityPlacement> gravity_;
};

std::vector<SceneObject> Floor() { return {{"floor", Plane{}, ""}}; }

CurveSample Swing(double t) {
  return {std::sin(7.0 * t), 7.0 * std::cos(7.0 * t), -49.0 * std::sin(7.0 * t)};
}

// Case (5), joints moving.
TEST(GravityPlacement, CenterOfMassFallsOnAParabolaAtAnyStep) {
  for (const double dt : {1.0 / 30.0, 0.013, 0.2}) {
    Fall fall(test::TwoLinks(), Floor(), "knee", Swing);
    fall.Start({0, 0, 50}, {1, 2, 3});
    const Vec3 start = fall.com();
    // The knee's rate adds to the velocity of the CoM.
    Fall other(test::TwoLinks(), Floor(), "knee", Swing);
    other.Start({0, 0, 50}, {1, 2, 3});
    other.Step(1e-3);
    const Vec3 v = (other.com() - start) / 1e-3 + Vec3(0, 0, 0.5 * kG * 1e-3);
    fall.Run(10, dt);
    const double t = fall.time();
    EXPECT_LE((fall.com() - (start + v * t - Vec3(0, 0, 0.5 * kG * t * t))).norm(), 1e-10);
    EXPECT_EQ(fall.pin(), "none");
  }
}

TEST(GravityPlacement, CenterOfMassOfAStiffFigureIsExact) {
  for (const double dt : {1.0 / 30.0, 0.013, 0.2}) {
    Fall fall(test::Pogo(), Floor());
    fall.Start({0, 0, 50}, {1, 2, 3});
    const Vec3 start = fall.com();
    fall.Run(10, dt);
    const double t = fall.time();
    EXPECT_LE((fall.com() - (start + Vec3(t, 2 * t, 3 * t - 0.5 * kG * t * t))).norm(), 1e-12);
  }
}

TEST(GravityPlacement, ApexIsWhenTheFallingVelocityIsZero) {
  for (const double dt : {1.0 / 30.0, 0.013, 0.2}) {
    Fall fall(test::Pogo(), Floor());
    fall.Start({0, 0, 50}, {1, 0, 3});
    fall.Run(static_cast<int>(std::ceil(0.5 / dt)), dt);
    EXPECT_NEAR(fall.TimeOf(Kind::kApex), 3.0 / kG, 1e-12);
  }
}

// Case (6): the sole is 0.55 m below the root.
TEST(GravityPlacement, LandsWhenAndWhereItTouches) {
  for (const double dt : {1.0 / 30.0, 0.013, 0.2}) {
    Fall fall(test::Pogo(), Floor());
    fall.Start({0, 0, 1.05}, {0.5, 0, 2});
    fall.Run(static_cast<int>(std::ceil(0.7 / dt)), dt);
    const double landing = (2.0 + std::sqrt(4.0 + 2.0 * kG * 0.5)) / kG;
    EXPECT_NEAR(fall.TimeOf(Kind::kLanding), landing, 1e-9);
    EXPECT_NEAR(fall.clearance(), 0.0, 1e-9);
    EXPECT_EQ(fall.pin(), "foot");
  }
}

TEST(GravityPlacement, LandsOnAThinBoxHoweverFast) {
  const Box plate{{Mat3::Identity(), Vec3(0, 0, -0.0025)}, Vec3(1, 1, 0.0025)};
  for (const double speed : {1.0, 30.0, 300.0}) {
    Fall fall(test::Pogo(), {{"plate", plate, ""}});
    fall.Start({0, 0, 0.55 + 0.77 * speed / 30.0}, {0, 0, -speed});
    fall.Run(3, 1.0 / 30.0);
    EXPECT_EQ(fall.pin(), "foot") << speed << " m/s";
    EXPECT_NEAR(fall.clearance(), 0.0, 1e-9);
  }
}

// Case (3), after case (6).
TEST(GravityPlacement, DoesNotHopAfterALanding) {
  for (const double dt : {1.0 / 30.0, 1.0 / 300.0}) {
    for (const double end_time : {0.1, 0.4}) {
      // The knee gives way around the landing and stays bent.
      const Script bend = [=](double t) {
        const Interval interval = Interval::Cubic(0.2, 0.0, 0.9, 0.0, end_time);
        return t < end_time ? interval.At(t) : CurveSample{0.9, 0.0, 0.0};
      };
      Fall fall(test::TwoLinks(), Floor(), "knee", bend);
      fall.Start({0, 0, 0.95}, {0, 0, -1.5});
      fall.Run(static_cast<int>(1.0 / dt), dt);
      EXPECT_FALSE(std::isnan(fall.TimeOf(Kind::kLanding)));
      EXPECT_EQ(fall.events.size(), 1u) << "step " << dt << ", bent after " << end_time;
    }
  }
}

TEST(GravityPlacement, KeepsThePinInPlaceWhileTouching) {
  Fall fall(test::TwoLinks(), Floor(), "knee", [](double t) {
    return CurveSample{0.3 * t * t, 0.6 * t, 0.6};
  });
  fall.Start({0, 0, 0.85}, {0, 0, 0});
  EXPECT_EQ(fall.pin(), "foot");
  const Vec3 pin = fall.pin_now();
  for (int i = 0; i < 30; ++i) {
    fall.Step(1.0 / 30.0);
    EXPECT_LE((fall.pin_now() - pin).norm(), 1e-12);
  }
  EXPECT_TRUE(fall.events.empty());
}

// Over its foot the CoM of TwoLinks is B cos(knee) higher than at a right angle:
// (3 * 0.4 + 2 * 0.2) / 6.
constexpr double kB = 1.6 / 6.0;

// The knee that lets the pinned CoM fall with acceleration a + j t.
Script Falling(double a, double j) {
  return [=](double t) -> CurveSample {
    const double drop = 0.5 * a * t * t + j * t * t * t / 6.0, drop_d = a * t + 0.5 * j * t * t;
    const double angle = std::acos(1.0 - drop / kB);
    if (t == 0.0) return {0.0, std::sqrt(a / kB), 0.0};
    return {angle, drop_d / kB / std::sin(angle), 0.0};
  };
}

TEST(GravityPlacement, StaysPinnedWhileItsCenterOfMassFallsSlowerThanGravity) {
  Fall fall(test::TwoLinks(), Floor(), "knee", Falling(0.95 * kG, 0.0));
  fall.Start({0, 0, 0.85}, {0, 0, 0});
  fall.Run(20, 0.005);
  EXPECT_TRUE(fall.events.empty());
}

// Numbers in a file end somewhere: a figure never stands exactly on the ground.
TEST(GravityPlacement, TakesOffAtTheSameTimeAHairAboveOrInsideTheGround) {
  const double dt = 1e-4;
  std::vector<double> times;
  for (const double hair : {-9e-7, -3e-8, 0.0, 3e-8, 9e-7}) {
    Fall fall(test::TwoLinks(), Floor(), "knee", Falling(0.5 * kG, 40.0));
    fall.Start({0, 0, 0.85 + hair}, {0, 0, 0});
    fall.Run(1500, dt);
    times.push_back(fall.TimeOf(Kind::kTakeOff));
    EXPECT_NEAR(times.back(), times.front(), 1.5 * dt) << hair;
    EXPECT_EQ(fall.events.size(), 1u);
  }
}

// Case (4).
TEST(GravityPlacement, TakesOffWhenItsCenterOfMassWouldFallFasterThanGravity) {
  const double jerk = 40.0, exact = 0.5 * kG / jerk;
  double last_error = 1.0;
  for (const double dt : {4e-3, 2e-3, 1e-3, 5e-4}) {
    Fall fall(test::TwoLinks(), Floor(), "knee", Falling(0.5 * kG, jerk));
    fall.Start({0, 0, 0.85}, {0, 0, 0});
    fall.Run(static_cast<int>(0.16 / dt), dt);
    const double error = std::abs(fall.TimeOf(Kind::kTakeOff) - exact);
    EXPECT_LE(error, 6.0 * dt) << "step " << dt;
    EXPECT_LT(error, last_error);
    last_error = error;
    EXPECT_EQ(fall.pin(), "none");
  }
}

TEST(GravityPlacement, PinsTheNamedJointBeforeTakeOffAndAfterALanding) {
  Fall fall(test::TwoLinks(), Floor());
  fall.span.pin = fall.group("knee");
  fall.Start({0, 0, 0.85}, {0, 0, 0});
  EXPECT_EQ(fall.pin(), "knee");
  Fall drop(test::TwoLinks(), Floor());
  drop.span.pin = drop.group("foot");
  drop.span.landing_pin = drop.group("knee");
  drop.Start({0, 0, 1.0}, {0, 0, 0});
  drop.Run(30, 1.0 / 30.0);
  EXPECT_EQ(drop.pin(), "knee");
}

TEST(GravityPlacement, PinsTheJointNearestToTheContactWhereNoneIsNamed) {
  Fall upside(test::TwoLinks(), {{"ceiling", Plane{}, ""}}, "knee", [](double) {
    return CurveSample{3.0, 0.0, 0.0};
  });
  upside.Start({0, 0, 0.7}, {0, 0, 0});  // folded: the knee is lowest
  upside.Run(30, 1.0 / 30.0);
  EXPECT_EQ(upside.pin(), "knee");
  EXPECT_NEAR(upside.clearance(), 0.0, 1e-9);
}

TEST(GravityPlacement, StandsStillOneMillimetreInTheFloor) {
  Fall fall(test::Pogo(), Floor());
  fall.Start({0, 0, 0.549}, {0, 0, 0});
  fall.Run(30, 1.0 / 30.0);
  EXPECT_EQ(fall.now().X_WR.p, Vec3(0, 0, 0.549));
  EXPECT_TRUE(fall.events.empty());
}

TEST(GravityPlacement, FallsThroughNothing) {
  Fall fall(test::Pogo(), {});
  fall.Start({0, 0, 1}, {0, 0, 0});
  fall.Run(30, 1.0 / 30.0);
  EXPECT_NEAR(fall.now().X_WR.p.z(), 1.0 - 0.5 * kG, 1e-12);
}

// The leg is stretched into the floor faster than the body falls.
TEST(GravityPlacement, MovesOutOfWhatALimbWasStretchedInto) {
  Fall fall(test::TwoLinks(), Floor(), "knee", [](double t) {
    return t == 0.0 ? CurveSample{2.5, 0, 0} : CurveSample{0.1, 0, 0};
  });
  fall.Start({0, 0, 0.5}, {0, 0, 0});
  fall.Step(1.0 / 30.0);
  EXPECT_EQ(fall.pin(), "foot");
  EXPECT_NEAR(fall.clearance(), 0.0, 1e-9);
}

TEST(GravityPlacement, FindsTheFigureWithinAStep) {
  Fall fall(test::Pogo(), Floor());
  fall.Start({0, 0, 50}, {1, 2, 3});
  fall.Run(3, 0.1);
  FigureMotion between = fall.now();
  fall.PlaceEarlier(0.04, &between);
  EXPECT_NEAR(between.X_WR.p.z(), 50 + 3 * 0.26 - 0.5 * kG * 0.26 * 0.26, 1e-12);
}

}  // namespace
}  // namespace hazumi
