// Makers: what they report is what the project that they make does, and nothing else decides.

#include <algorithm>

#include "engine/bake/bake.h"
#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "engine/makers/flights/flights.h"
#include "engine/makers/jumps/jumps.h"
#include "engine/makers/throws/throws.h"
#include "engine/makers/trial_bakes.h"
#include "engine/project/compile.h"
#include "engine/project/figure_file.h"
#include "tests/unit/edit/placement/keyed_jump.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

// A project with its animation and motion.
struct Baked {
  explicit Baked(Project of) : project(std::move(of)) {
    Result<Compiled> compiled = CompileAnimation(project);
    EXPECT_TRUE(compiled.ok());
    animation = std::move(compiled.value().animation);
    Result<Motion> baked = Bake(animation);
    EXPECT_TRUE(baked.ok());
    motion = std::move(baked).value();
  }
  Project project;
  Animation animation;
  Motion motion;
};

Baked Standing() { return Baked(Session().project()); }

Baked WithBall() {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  return Baked(session.project());
}

template <typename T>
const T& Good(const Result<T>& result) {
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().ToString());
  return result.value();
}

TEST(MakeJump, ReportsTheFramesAndTheRiseOfItsMotion) {
  const Baked start = Standing();
  const auto made = makers::MakeJump({0.9, 0.0, 0.4}, start.motion.frames.front(), start.animation,
                                     start.project);
  const makers::JumpReport& report = Good(made).report;
  const Baked jump(made.value().project);
  const auto& spans = jump.project.placements;
  ASSERT_EQ(spans.size(), 3u);
  EXPECT_EQ(report.first, spans[0].first_frame);
  EXPECT_EQ(report.take_off, spans[0].last_frame);
  EXPECT_EQ(report.landing, spans[2].first_frame);
  EXPECT_EQ(report.last, spans[2].last_frame);
  double highest = 0.0;
  for (const MotionFrame& frame : jump.motion.frames) {
    highest = std::max(highest, frame.com.z());
  }
  // The flight is a whole number of frames, and its apex lies between two.
  EXPECT_NEAR(highest - jump.motion.frames[static_cast<size_t>(report.take_off)].com.z(),
              report.height, 0.06);
}

TEST(MakeJump, IsAsLowAsItGetsThereIfNoHeightIsGiven) {
  const Baked start = Standing();
  const MotionFrame& now = start.motion.frames.front();
  const auto low = makers::MakeJump({2.4, 0.0, {}}, now, start.animation, start.project);
  const double height = Good(low).report.height;
  ASSERT_GT(height, 0.16);  // the lowest that is tried is 0.15
  EXPECT_FALSE(
      makers::MakeJump({2.4, 0.0, height - 0.05}, now, start.animation, start.project).ok());
  const auto as_high = makers::MakeJump({2.4, 0.0, height}, now, start.animation, start.project);
  EXPECT_EQ(Good(as_high).project, low.value().project);
}

// The middle of the toes on a frame.
Vec3 ToesOn(int frame, const Baked& baked) {
  const Figure& figure = *baked.animation.figure;
  DynamicsWorkspace workspace(figure);
  const MotionFrame& now = baked.motion.frames[static_cast<size_t>(frame)];
  ComputePositions(figure, now.X_WR, now.q, &workspace);
  Vec3 middle = Vec3::Zero();
  for (const char* toe : {"r_toe", "l_toe"}) {
    middle += 0.5 * workspace.body(*figure.FindJoint(toe)).p;
  }
  return middle;
}

// The flight has the speed that its keys say, not that of the pin.
TEST(MakeJump, LandsOnItsSpotFromAPinAboveTheGround) {
  Session session;
  Project floating = session.project();
  floating.root.curves[kRootZ].keys[0].value += 0.008;
  const Baked start(std::move(floating));
  const auto made =
      makers::MakeJump({0.9, 0.0, {}}, start.motion.frames.front(), start.animation, start.project);
  const int landing = Good(made).report.landing;
  const Vec3 toes = ToesOn(landing, Baked(made.value().project));
  EXPECT_NEAR(toes.x(), 0.9, 0.03);
  EXPECT_NEAR(toes.y(), 0.0, 0.03);
}

TEST(MakeJump, BringsTheFeetOfAStrideTogether) {
  Session session;
  for (const auto& [joint, angle] : {std::pair{"r_hip_flexion", 35.0},
                                     {"r_knee", 15.0},
                                     {"l_hip_flexion", -15.0},
                                     {"l_knee", 25.0},
                                     {"l_hip_abduction", 12.0}}) {
    Do(&session, "pose.rotate", {{"joint", joint}, {"to", angle}});
  }
  Do(&session, "root.to_ground", edit::Json::object());
  const Baked start(session.project());
  const auto made =
      makers::MakeJump({1.1, 0.0, {}}, start.motion.frames.front(), start.animation, start.project);
  const makers::JumpReport report = Good(made).report;
  const Baked jump(made.value().project);
  EXPECT_NEAR(ToesOn(report.landing, jump).x(), 1.1, 0.03);
  const MotionFrame& off = jump.motion.frames[static_cast<size_t>(report.take_off)];
  const Figure& figure = *jump.animation.figure;
  for (const char* hinge : {"hip_flexion", "hip_abduction", "knee"}) {
    const double right = off.q[figure.FindJoint("r_" + std::string(hinge))->value()];
    const double left = off.q[figure.FindJoint("l_" + std::string(hinge))->value()];
    EXPECT_NEAR(right, left, 1e-6) << hinge;
  }
}

TEST(MakeJump, AsksMoreThanPeoplesLegsGiveOnlyIfNoHeightIsGiven) {
  const Baked start = Standing();
  const MotionFrame& now = start.motion.frames.front();
  const Vec3 far(6.0, 0.0, 0.0);
  for (const double height : {0.3, 0.8, 1.5}) {
    EXPECT_FALSE(
        makers::MakeJump({far.x(), 0.0, height}, now, start.animation, start.project).ok());
  }
  const auto made = makers::MakeJump({far.x(), 0.0, {}}, now, start.animation, start.project);
  EXPECT_NEAR(ToesOn(Good(made).report.landing, Baked(made.value().project)).x(), far.x(), 0.03);
}

TEST(AimJump, OntoWhereItLandsLeavesItWhereItWas) {
  const Baked start = Standing();
  const auto made = makers::MakeJump({0.9, 0.0, 0.4}, start.motion.frames.front(), start.animation,
                                     start.project);
  const Baked jump(Good(made).project);
  const auto aimed = makers::AimJump({{}, {}, 0.4}, made.value().report.take_off, jump.animation,
                                     jump.motion, jump.project);
  const makers::JumpReport &before = made.value().report, &after = Good(aimed).report;
  EXPECT_EQ(after.take_off, before.take_off);
  EXPECT_EQ(after.landing, before.landing);
  EXPECT_EQ(makers::AimJump({}, before.last, jump.animation, jump.motion, jump.project).ok(),
            false);
}

TEST(MakeThrow, ReportsWhenAndHowFastTheBallIsLetGo) {
  constexpr double kRadius = 0.037, g = 9.81;
  const Baked start = WithBall();
  const Vec3 spot(2.0, 0.3, 0.0);
  const auto made =
      makers::MakeThrow({0, spot, {}}, start.motion.frames.front(), start.animation, start.project);
  const makers::ThrowReport& report = Good(made).report;
  const Baked thrown(made.value().project);
  EXPECT_EQ(report.release, thrown.project.held_objects[0].release_frame);
  EXPECT_EQ(report.region, thrown.project.regions.back().name);
  EXPECT_GT(report.muscle, 0.0);
  const auto ball = [&](int frame) {
    return thrown.motion.frames[static_cast<size_t>(frame)].objects[0].X_WO.p;
  };
  const double dt = thrown.motion.rate.SecondsAt(1);
  const Vec3 velocity =
      (ball(report.release + 1) - ball(report.release)) / dt + Vec3(0.0, 0.0, 0.5 * g * dt);
  EXPECT_LT((velocity - report.velocity).norm(), 1e-3);  // keys are rounded
  EXPECT_LT((ball(report.down) - spot - kRadius * Vec3::UnitZ()).norm(), 1e-9);
}

TEST(AimThrow, IsFoundByHasThrowAloneOnceItIsThrown) {
  const Baked held = WithBall();
  EXPECT_FALSE(makers::HasThrow(0, 0.0, held.animation, held.project));
  EXPECT_FALSE(
      makers::AimThrow({0, Vec3(2.0, 0.0, 0.0), {}}, 0.0, held.animation, held.motion, held.project)
          .ok());
  const auto made = makers::MakeThrow({0, Vec3(2.0, 0.3, 0.0), {}}, held.motion.frames.front(),
                                      held.animation, held.project);
  const Baked thrown(Good(made).project);
  EXPECT_TRUE(makers::HasThrow(0, 0.0, thrown.animation, thrown.project));
  const Vec3 other(2.6, 0.0, 0.0);
  const auto aimed =
      makers::AimThrow({0, other, {}}, 0.0, thrown.animation, thrown.motion, thrown.project);
  const Baked again(Good(aimed).project);
  const Vec3 lies =
      again.motion.frames[static_cast<size_t>(aimed.value().report.down)].objects[0].X_WO.p;
  EXPECT_LT((lies - other).head<2>().norm(), 1e-9);
}

TEST(MakeFlight, ReportsTheSpeedWithWhichGravityTakesOver) {
  Session session;
  KeyJump(7.0, &session);
  const makers::FlightSpan span = {kJumpTakeOff + 1, kJumpLanding - 1};
  const auto made = makers::MakeFlight(span, session.project());
  const makers::FlightReport& report = Good(made).report;
  EXPECT_GE(report.trials, 1);
  const Baked flown(made.value().project);
  const MotionFrame& first = flown.motion.frames[static_cast<size_t>(report.by_gravity)];
  EXPECT_LT((first.after.root_v - report.root_velocity).norm(), 1e-9);
  EXPECT_EQ(flown.project.placements.back().first_frame, report.by_gravity);
}

TEST(MakeFlight, RefusesAFlightOfTwoFramesAndOneBeyondTheProject) {
  Session session;
  KeyJump(7.0, &session);
  EXPECT_FALSE(makers::MakeFlight({5, 6}, session.project()).ok());
  EXPECT_FALSE(makers::MakeFlight({5, 100000}, session.project()).ok());
}

// The window and a script find the same project as whoever calls the maker.
TEST(Makers, AnOperatorPutsTheProjectOfItsMaker) {
  const Baked start = WithBall();
  const MotionFrame& now = start.motion.frames.front();
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  Do(&session, "throw.add", {{"object", "ball"}, {"x", 2.0}, {"y", 0.3}});
  const auto thrown =
      makers::MakeThrow({0, Vec3(2.0, 0.3, 0.0), {}}, now, start.animation, start.project);
  EXPECT_EQ(session.project(), Good(thrown).project);
  Do(&session, "edit.undo");
  Do(&session, "jump.add", {{"x", 0.9}, {"y", 0.0}});
  const auto jumped = makers::MakeJump({0.9, 0.0, {}}, now, start.animation, start.project);
  EXPECT_EQ(session.project(), Good(jumped).project);
}

TEST(TrialBakes, BakeAsBakeDoesAndCountTheirWork) {
  const Baked start = Standing();
  makers::TrialBakes trials;
  const int last = start.animation.last_frame;
  const auto first = trials.BakeTo(last, start.animation);
  EXPECT_EQ(Good(first)->frames.back().q, start.motion.frames.back().q);
  const double work = trials.work();
  Good(trials.BakeTo(last, start.animation));
  EXPECT_GT(trials.work(), work);
}

// The human with other names for its joints.
std::string OtherName(const std::string& joint) {
  constexpr std::pair<const char*, const char*> kNames[] = {
      {"shoulder", "Arm"}, {"elbow", "ForeArm"}, {"wrist", "Hand"}, {"hip", "UpLeg"},
      {"knee", "Leg"},     {"ankle", "Foot"},    {"toe", "ToeBase"}};
  for (const auto& [human, other] : kNames) {
    for (const auto& [letter, side] : {std::pair{"r_", "Right"}, {"l_", "Left"}}) {
      const std::string name = letter + std::string(human);
      if (joint.starts_with(name)) return side + (other + joint.substr(name.size()));
    }
  }
  for (const auto& [human, other] :
       {std::pair{"waist", "Spine"}, {"chest", "Spine1"}, {"neck", "Neck"}}) {
    if (joint.starts_with(human)) return other + joint.substr(std::string_view(human).size());
  }
  return joint;
}

Project WithOtherNames(Project project) {
  FigureSpec spec = WithMirroredTwins(project.figure.spec);
  spec.mirror.reset();
  for (JointSpec& joint : spec.joints) {
    joint.name = OtherName(joint.name);
    joint.parent = OtherName(joint.parent);
  }
  project.skin = {};
  project.figure = {};
  project.figure.embedded_json = FigureText(spec);
  project.figure.spec = std::move(spec);
  for (auto& joint : project.joints) joint.name = OtherName(joint.name);
  for (auto& object : project.held_objects) object.joint = OtherName(object.joint);
  return project;
}

void ExpectSameKeys(const Project& human, const Project& other) {
  ASSERT_EQ(human.joints.size(), other.joints.size());
  for (size_t i = 0; i < human.joints.size(); ++i) {
    EXPECT_EQ(OtherName(human.joints[i].name), other.joints[i].name);
    const auto &is = other.joints[i].value.keys, &was = human.joints[i].value.keys;
    ASSERT_EQ(is.size(), was.size()) << other.joints[i].name;
    for (size_t k = 0; k < is.size(); ++k) {
      EXPECT_EQ(is[k].frame, was[k].frame) << other.joints[i].name;
      EXPECT_NEAR(is[k].value, was[k].value, 1e-6) << other.joints[i].name;
    }
  }
}

TEST(Makers, MakeTheSameMovesOfAFigureWithOtherNames) {
  const Baked human = WithBall(), other(WithOtherNames(human.project));
  const makers::ThrowTarget spot{0, Vec3(2.0, 0.5, 0.0), {}};
  const auto thrown =
      makers::MakeThrow(spot, human.motion.frames.front(), human.animation, human.project);
  const auto other_thrown =
      makers::MakeThrow(spot, other.motion.frames.front(), other.animation, other.project);
  ExpectSameKeys(Good(thrown).project, Good(other_thrown).project);
  const auto jump = makers::MakeJump({0.9, 0.0, 0.4}, human.motion.frames.front(), human.animation,
                                     human.project);
  const auto other_jump = makers::MakeJump({0.9, 0.0, 0.4}, other.motion.frames.front(),
                                           other.animation, other.project);
  ExpectSameKeys(Good(jump).project, Good(other_jump).project);
  EXPECT_EQ(other_jump.value().project.placements.front().pin, "RightToeBase");
}

}  // namespace
}  // namespace hazumi::test
