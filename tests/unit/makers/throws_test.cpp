// Throws that are made, of each style, near and far: where the object comes down, and what the
// figure does meanwhile.

#include "engine/makers/throws/throws.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/project_writer.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/edit/held/throws.h"
#include "tests/unit/makers/own_body.h"

namespace hazumi::test {
namespace {

using edit::Session;

struct Case {
  ThrowStyle style;
  Vec3 spot;
  bool has_box = false;  // in between
};

// 20 spots at 1 to 8 m for each style, up to 25 degrees to either side, every fourth on a table.
std::vector<Case> Cases() {
  constexpr int kSpots = 20;
  std::vector<Case> cases;
  for (const ThrowStyle style : {ThrowStyle::kUnderarm, ThrowStyle::kOverarm, ThrowStyle::kPush}) {
    for (int i = 0; i < kSpots; ++i) {
      const double away = 1.0 + 7.0 * i / (kSpots - 1);
      const double side = 12.5 * kDegree * ((i * 7) % 5 - 2);
      const double up = i % 4 == 3 ? 0.6 : 0.0;
      cases.push_back({style, {away * std::cos(side), away * std::sin(side), up}, i % 7 == 5});
    }
  }
  return cases;
}

void AddBox(const char* name, const Vec3& middle, const Vec3& size, Session* session) {
  Do(session, "object.add_box",
     {{"name", name},
      {"x", middle.x()},
      {"y", middle.y()},
      {"z", middle.z()},
      {"size_x", size.x()},
      {"size_y", size.y()},
      {"size_z", size.z()}});
}

// Whether the ball is in a link other than those of the right arm in the half second after it was
// let go.
bool FliesThroughBody(const Motion& motion, const Figure& figure, int release) {
  constexpr double kRadius = 0.037, kTouch = 0.01;  // [m]
  const JointIndex arm = figure.group(*figure.FindGroup("r_shoulder")).first;
  DynamicsWorkspace ws(figure);
  for (int f = release; f < release + 15; ++f) {
    const MotionFrame& frame = motion.frames[static_cast<size_t>(f)];
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    const Vec3 ball = BallIn(motion, f);
    for (const Link& link : figure.links()) {
      if (!link.joint.is_valid() || figure.IsBeyond(link.joint, arm)) continue;
      const BodyScratch& body = ws.body(link.joint);
      const Capsule now = {body.p + body.R * link.capsule.a, body.p + body.R * link.capsule.b,
                           link.capsule.radius};
      if (SignedDistance(Capsule{ball, ball, kRadius}, now).value < -kTouch) return true;
    }
  }
  return false;
}

TEST(Throws, OfAHighArcMissTheOwnHead) {
  for (const char* style : {"underarm", "overarm", "push"}) {
    for (const double height : {0.3, 0.5, 0.8, 1.2}) {
      Session session;
      AddBall(&session);
      edit::Json onto = Onto(Vec3(2.6, 0.2, 0.0));
      onto["style"] = style;
      onto["height"] = height;
      Do(&session, "throw.add", onto);
      const Motion& motion = ThrowMotion(&session);
      EXPECT_FALSE(FliesThroughBody(motion, session.figure(), ReleaseOf(session)))
          << style << " " << height;
      EXPECT_NEAR(RiseOf(motion, ReleaseOf(session)), height, 0.03) << style;
    }
  }
}

TEST(Throws, OfEachStyleComeDownOnTheSpotWithoutHarm) {
  std::vector<double> times, muscle;  // [ms]
  double worst = 0.0;
  for (const Case& wanted : Cases()) {
    SCOPED_TRACE(std::string(NameOf(wanted.style)) + ", " + std::to_string(wanted.spot.norm()) +
                 " m");
    Session session;
    AddBall(&session);
    const Vec3& spot = wanted.spot;
    if (wanted.has_box) {
      AddBox("box", Vec3(0.55 * spot.x(), 0.55 * spot.y(), 0.4), {0.3, 0.8, 0.8}, &session);
    }
    if (spot.z() > 0.0) {
      AddBox("table", spot - Vec3(0.0, 0.0, 0.05), {0.4, 0.4, 0.1}, &session);
    }
    makers::ThrowTarget target;
    target.spot = spot;
    target.style = wanted.style;
    const MotionFrame now = ThrowMotion(&session).frames[0];
    const auto start = std::chrono::steady_clock::now();
    const auto made = makers::MakeThrow(target, now, *session.animation(), session.project());
    const auto took = std::chrono::steady_clock::now() - start;
    times.push_back(std::chrono::duration<double, std::milli>(took).count());
    ASSERT_TRUE(made.ok()) << made.error().ToString();
    const makers::ThrowReport& report = made.value().report;
    muscle.push_back(report.muscle);
    const Animation animation = CompileAnimation(made.value().project).value().animation;
    const Motion motion = Bake(animation).value();
    const Vec3 lies = spot + Vec3(0.0, 0.0, 0.037);
    const double miss = (LandsAt(motion, report.release, lies.z()) - lies).norm();
    worst = std::max(worst, miss);
    EXPECT_LE(miss, 0.005);
    for (int f = report.release; wanted.has_box && f < report.down; ++f) {
      const Vec3 p = BallIn(motion, f) - Vec3(0.55 * spot.x(), 0.55 * spot.y(), 0.4);
      EXPECT_FALSE(std::abs(p.x()) < 0.15 && std::abs(p.y()) < 0.4 && std::abs(p.z()) < 0.4) << f;
    }
    EXPECT_FALSE(FliesThroughBody(motion, *animation.figure, report.release));
    const Most most = MostOf(motion, *animation.figure);
    EXPECT_LE(most.rate, 1500.0 * kDegree) << most.fastest;
    EXPECT_LE(most.beyond, 0.1 * kDegree);
    EXPECT_LE(most.depth, 0.01) << most.deepest;
  }
  std::sort(times.begin(), times.end());
  std::sort(muscle.begin(), muscle.end());
  std::printf(
      "%zu throws: median %.0f ms, longest %.0f ms; largest miss %.2f mm; of what muscles can give "
      "median %.0f %%, most %.0f %%\n",
      times.size(), times[times.size() / 2], times.back(), 1000.0 * worst,
      100.0 * muscle[muscle.size() / 2], 100.0 * muscle.back());
}

// 60 moves of half a metre in all; each is one edit of the project, with its bake up to the spot.
TEST(Throws, FollowASpotThatIsDragged) {
  constexpr int kMoves = 60;
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.5, 0.2, 0.0)));
  const std::string before = WriteProject(session.project());
  std::vector<double> times;
  for (int i = 1; i <= kMoves; ++i) {
    const Vec3 spot(2.5 + 0.5 * i / kMoves, 0.2, 0.0);
    edit::Json onto = Onto(spot);
    onto["drag"] = "spot";
    const auto start = std::chrono::steady_clock::now();
    Do(&session, "held.throw_onto", onto);
    const Motion& motion = ThrowMotion(&session);
    const auto took = std::chrono::steady_clock::now() - start;
    times.push_back(std::chrono::duration<double, std::milli>(took).count());
    const Vec3 lies = spot + Vec3(0.0, 0.0, 0.037);
    EXPECT_LE((LandsAt(motion, ReleaseOf(session), lies.z()) - lies).norm(), 0.005) << i;
  }
  Do(&session, "edit.undo");
  EXPECT_EQ(WriteProject(session.project()), before);
  std::sort(times.begin(), times.end());
  std::printf("%d moves: median %.0f ms, longest %.0f ms\n", kMoves, times[kMoves / 2],
              times.back());
}

// An arm that is drawn back in the frame of the throw keeps its pose.
TEST(Throws, BeginWithAWindUpThatIsThere) {
  Session session;
  AddBall(&session);
  const std::pair<const char*, double> pose[] = {{"r_shoulder_flexion", 95.0},
                                                 {"r_shoulder_rotation", 10.0},
                                                 {"r_shoulder_abduction", 90.0},
                                                 {"r_elbow_flexion", 95.0}};
  for (const auto& [hinge, angle] : pose) {
    Do(&session, "key.set", {{"curve", hinge}, {"frame", 0}, {"value", 0}});
    Do(&session, "key.set", {{"curve", hinge}, {"frame", 12}, {"value", angle}});
  }
  Do(&session, "time.frame", {{"frame", 12}});
  Do(&session, "throw.add", Onto(Vec3(3.0, 0.0, 0.0)));
  ASSERT_EQ(session.project().goals.size(), 1u);
  EXPECT_EQ(session.project().goals[0].style, ThrowStyle::kOverarm);
  const Motion& motion = ThrowMotion(&session);
  for (const auto& [hinge, angle] : pose) {
    const JointIndex j = *session.figure().FindJoint(hinge);
    EXPECT_NEAR(motion.frames[12].q[j.value()], angle * kDegree, 1e-9) << hinge;
  }
  EXPECT_LE(ReleaseOf(session), 12 + 15);
}

// A goal of kind object says where it comes down; aimed again, the throw follows it.
TEST(Throws, FollowTheirGoal) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.0, 0.2, 0.0)));
  const Vec3 place(2.6, -0.2, 0.037);
  Do(&session, "goal.set",
     {{"goal", "throw"}, {"position_x", place.x()}, {"position_y", place.y()}, {"height", 1.0}});
  Do(&session, "goal.aim", {{"goal", "throw"}});
  const Motion& motion = ThrowMotion(&session);
  EXPECT_LE((LandsAt(motion, ReleaseOf(session), place.z()) - place).norm(), 0.005);
  EXPECT_NEAR(RiseOf(motion, ReleaseOf(session)), 1.0, 0.02);
  Do(&session, "held.set", {{"object", "ball"}, {"name", "apple"}});
  EXPECT_EQ(session.project().goals[0].object, "apple");
  Do(&session, "held.remove", {{"object", "apple"}});
  EXPECT_TRUE(session.project().goals.empty());
}

TEST(Throws, OntoASpotThatIsTooHighAreRefused) {
  Session session;
  AddBall(&session);
  edit::Json onto = Onto(Vec3(1.5, 0.0, 3.2));
  onto["height"] = 0.3;
  EXPECT_TRUE(Refused(&session, "throw.add", onto).message.ends_with("give a greater height"));
  Do(&session, "throw.add", Onto(Vec3(1.5, 0.0, 1.9)));
  const Motion& motion = ThrowMotion(&session);
  const Vec3 lies(1.5, 0.0, 1.937);
  EXPECT_LE((LandsAt(motion, ReleaseOf(session), lies.z()) - lies).norm(), 0.005);
  EXPECT_FALSE(session.project().goals[0].height_m);
}

// Changed among its properties, a goal of another style and spot moves the keys that were made.
TEST(Throws, FollowAGoalThatWasChangedWithAllTheirKeys) {
  Session changed, at_once;
  AddBall(&changed);
  AddBall(&at_once);
  Do(&changed, "throw.add", Onto(Vec3(2.0, 0.3, 0.0)));
  Do(&changed, "goal.set",
     {{"goal", "throw"}, {"style", "overarm"}, {"position_x", 3.0}, {"position_y", -0.4}});
  Do(&changed, "goal.aim", {{"goal", "throw"}});
  edit::Json onto = Onto(Vec3(3.0, -0.4, 0.0));
  onto["style"] = "overarm";
  Do(&at_once, "throw.add", onto);
  // But for the time of the swing, which is that of the first style.
  for (const char* hinge : {"chest_rotation", "l_elbow_flexion", "r_hip_flexion"}) {
    const auto value = [&](const Session& session) {
      return FindCurve(hinge, session.project())->keys[1].value;
    };
    EXPECT_NEAR(value(changed), value(at_once), 1e-6) << hinge;
  }
}

TEST(Throws, KeepTheReleaseThatIsMoved) {
  for (const int by : {-2, 3}) {
    Session session;
    AddBall(&session);
    Do(&session, "throw.add", Onto(Vec3(2.0, 0.3, 0.0)));
    const int release = ReleaseOf(session) + by;
    Do(&session, "held.set", {{"object", "ball"}, {"release", release}});
    EXPECT_EQ(session.project().goals[0].frame, release);
    Do(&session, "held.throw_onto", Onto(Vec3(2.2, 0.3, 0.0)));
    EXPECT_EQ(ReleaseOf(session), release);
    ASSERT_EQ(session.project().goals.size(), 1u);
    ASSERT_EQ(session.project().regions.size(), 1u);
    EXPECT_EQ(session.project().regions[0].first_frame, release);
    const Motion& motion = ThrowMotion(&session);
    const Vec3 lies(2.2, 0.3, 0.037);
    EXPECT_LE((LandsAt(motion, release, lies.z()) - lies).norm(), 0.005) << by;
  }
}

TEST(Throws, AreAimedAgainWhereTheProjectBeginsLater) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.0, 0.3, 0.0)));
  Do(&session, "placement.remove", {{"index", 0}});
  Do(&session, "time.range", {{"first", 5}});
  Do(&session, "goal.aim", {{"goal", "throw"}});
  const int release = ReleaseOf(session);
  Do(&session, "time.range", {{"first", release - 6}});
  Do(&session, "goal.aim", {{"goal", "throw"}});
  EXPECT_EQ(ReleaseOf(session), release);
}

TEST(Throws, OfAGoalThatNobodyThrowsAreRefused) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.0, 0.3, 0.0)));
  Do(&session, "goal.add",
     {{"kind", "object"}, {"name", "other"}, {"object", "ball"}, {"frame", 3}});
  const std::string before = WriteProject(session.project());
  EXPECT_NE(Refused(&session, "goal.aim", {{"goal", "other"}}).message.find("nobody lets go"),
            std::string::npos);
  EXPECT_EQ(WriteProject(session.project()), before);
}

TEST(Throws, AreMadeWhereTheMethodIsThePapersToo) {
  Session session;
  AddBall(&session);
  Do(&session, "solver.set", {{"method", "paper"}});
  Do(&session, "throw.add", Onto(Vec3(2.0, 0.3, 0.0)));
  EXPECT_FALSE(session.project().regions[0].contacts.self);
}

// The arm leaves a region of both arms; each keeps its drives.
TEST(Throws, TakeTheArmOutOfARegionOfBothArms) {
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 40}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 12}});
  Do(&session, "region.add",
     {{"name", "arms"}, {"first", 2}, {"last", 20}, {"joints", {"r_shoulder+", "l_shoulder+"}}});
  Do(&session, "drive.add",
     {{"region", "arms"}, {"kind", "spring"}, {"joints", {"r_shoulder", "l_elbow"}}});
  Do(&session, "held.throw_onto", Onto(Vec3(2.0, 0.3, 0.0)));
  const std::vector<ProjectRegion>& regions = session.project().regions;
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].first_frame, 2);
  EXPECT_EQ(regions[1].first_frame, 12);
  ASSERT_EQ(regions[0].drives.size(), 1u);
  EXPECT_EQ(regions[0].drives[0].joints[0].name, "l_elbow");
}

// A rise that was found to pass something is not asked for once that is gone.
TEST(Throws, RiseOnlyAsLongAsSomethingStandsInBetween) {
  Session session;
  AddBall(&session);
  AddBox("box", {1.2, 0.0, 0.5}, {0.2, 1.0, 1.0}, &session);
  Do(&session, "throw.add", Onto(Vec3(2.2, 0.0, 0.0)));
  const double over = RiseOf(ThrowMotion(&session), ReleaseOf(session));
  Do(&session, "object.remove", {{"object", "box"}});
  Do(&session, "goal.aim", {{"goal", "throw"}});
  EXPECT_LT(RiseOf(ThrowMotion(&session), ReleaseOf(session)), over - 0.05);
}

TEST(Throws, BeforeSomebodyTakesTheObjectAreRefused) {
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 80}});
  AddBall(&session);
  Do(&session, "time.frame", {{"frame", 35}});
  Do(&session, "held.pass", {{"object", "ball"}, {"joint", "l_wrist"}});
  Do(&session, "time.frame", {{"frame", 0}});
  const std::string message = Refused(&session, "throw.add", Onto(Vec3(2.5, 0.0, 0.0))).message;
  EXPECT_NE(message.find("l_wrist takes \"ball\" in frame 35"), std::string::npos) << message;
}

}  // namespace
}  // namespace hazumi::test
