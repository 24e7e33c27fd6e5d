// Aims: the motion that is baked with the torques they find meets the goals.

#include "engine/makers/aims/aims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include "engine/dynamics/kinematics.h"
#include "tests/unit/makers/aim_scene.h"

namespace hazumi::test {
namespace {

using makers::AimReport;
using makers::MadeAim;

// Aims at random poses; how many are met within a tenth of a degree, in a bake of the whole
// project.
int PosesMet(const AimScene& scene, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<double> times;  // of an aim, its proof included [ms]
  int met = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> angles = scene.RandomPose(&random);
    const Project project = scene.WithPose(angles);
    const auto start = std::chrono::steady_clock::now();
    const Result<MadeAim> made = makers::MakeAim("meet", project, scene.animation.figure);
    const auto took = std::chrono::steady_clock::now() - start;
    times.push_back(std::chrono::duration<double, std::milli>(took).count());
    if (!made.ok()) {
      ADD_FAILURE() << i << ": " << made.error().ToString();
      continue;
    }
    const Motion motion = MotionOf(made.value().project);
    const VecX& q = At(scene.last, motion).before.q;
    double worst = 0.0;
    for (size_t k = 0; k < angles.size(); ++k) {
      worst = std::max(worst, std::abs(q[scene.hinges()[k].value()] / kDegree - angles[k]));
    }
    EXPECT_LT(worst, 0.1) << i;
    EXPECT_NEAR(worst * kDegree, made.value().report.goals[0].angle, 1e-9);
    met += worst < 0.1 ? 1 : 0;
  }
  std::sort(times.begin(), times.end());
  std::printf("%d aims: median %.1f ms, longest %.1f ms\n", count, times[times.size() / 2],
              times.back());
  return met;
}

TEST(Aim, ARightArmThatIsThrownMeetsFortyRandomPoses) {
  EXPECT_EQ(PosesMet(AimScene("throw.kfa", 5, 15, "r_shoulder"), 1, 40), 40);
}
TEST(Aim, ALeftArmMeetsTwentyRandomPoses) {
  EXPECT_EQ(PosesMet(AimScene("throw.kfa", 5, 15, "l_shoulder"), 2, 20), 20);
}
TEST(Aim, ALegInFlightMeetsTwentyRandomPoses) {
  EXPECT_EQ(PosesMet(AimScene("jump.kfa", 8, 16, "l_hip"), 3, 20), 20);
}
TEST(Aim, ANeckMeetsTwentyRandomPoses) {
  EXPECT_EQ(PosesMet(AimScene("throw.kfa", 5, 15, "neck"), 4, 20), 20);
}

// Poses in which passive swings end need nothing.
TEST(Aim, GivesNoMuscleToWhatASwingMeets) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> friction(0.5, 1.0), rate(-400.0, 400.0);
  for (int i = 0; i < 20; ++i) {
    AimScene scene("throw.kfa", 5, 15, "r_shoulder");
    scene.project.regions[0].friction.default_factor = friction(random);
    for (const char* hinge : {"r_shoulder_flexion", "r_elbow_flexion"}) {
      ProjectCurve* const curve = CurveNamed(hinge, scene.figure(), &scene.project).value();
      ProjectKey key = KeyToChange(5.0, *curve);
      key.rate = rate(random);
      PutKey(key, curve);
    }
    const Motion swing = MotionOf(scene.project);
    std::vector<double> angles;
    for (const JointIndex j : scene.hinges()) {
      angles.push_back(At(15, swing).before.q[j.value()] / kDegree);
    }
    const Result<MadeAim> made = makers::MakeAim("meet", scene.WithPose(angles), nullptr);
    ASSERT_TRUE(made.ok()) << made.error().ToString();
    EXPECT_TRUE(made.value().report.is_loose) << i;
    EXPECT_EQ(made.value().report.muscle, 0.0);
    EXPECT_TRUE(made.value().project.regions[0].drives.empty());
  }
}

TEST(Aim, APalmReachesTwentyPoints) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  const Motion swing = MotionOf(scene.project);
  std::mt19937 random(6);
  const JointIndex wrist = *scene.figure().FindJoint("r_wrist_deviation");
  const Vec3 palm(0.0, 0.0, -0.09);
  DynamicsWorkspace ws(scene.figure());
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> angles = scene.RandomPose(&random);
    MotionFrame frame = At(15, swing);
    for (size_t k = 0; k < angles.size(); ++k) {
      frame.q[scene.hinges()[k].value()] = angles[k] * kDegree;
    }
    ComputePositions(scene.figure(), frame.X_WR, frame.q, &ws);
    const Vec3 place = ws.body(wrist).p + ws.body(wrist).R * palm;
    const Result<MadeAim> made =
        makers::MakeAim("touch", scene.WithPoint("r_wrist", palm, place), nullptr);
    if (!made.ok()) {
      ADD_FAILURE() << i << ": " << made.error().ToString();
      continue;
    }
    const MotionFrame there = At(15, MotionOf(made.value().project));
    ComputePositions(scene.figure(), there.X_WR, there.before.q, &ws);
    const double off = (ws.body(wrist).p + ws.body(wrist).R * palm - place).norm();
    EXPECT_LT(off, 0.005) << i;
    EXPECT_NEAR(off, made.value().report.goals[0].distance, 1e-9);
  }
}

TEST(Aim, AnArmComesToRest) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  const std::vector<double> angles = {40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0};
  const Result<MadeAim> made = makers::MakeAim("meet", scene.WithPose(angles, true), nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  const MotionFrame there = At(15, MotionOf(made.value().project));
  for (const JointIndex j : scene.hinges()) {
    EXPECT_LT(std::abs(there.before.qd[j.value()]), 8.0 * kDegree);
  }
  EXPECT_GT(made.value().report.muscle, 0.0);
  EXPECT_FALSE(made.value().report.strongest.empty());
}

// Finds torques of an aim anew, and leaves drives of the animator.
TEST(Aim, FindsItsTorquesAnewAndLeavesOthers) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  ProjectDrive spring;
  spring.joints = {{"r_wrist", false, {}}};
  project.regions[0].drives = {spring};
  std::erase_if(project.goals[0].joints, [](const JointRef& ref) {
    return ref.name == "r_wrist_flexion" || ref.name == "r_wrist_deviation";
  });
  const Result<MadeAim> made = makers::MakeAim("meet", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  const auto& drives = made.value().project.regions[0].drives;
  EXPECT_EQ(drives.size(), 6u);
  EXPECT_EQ(drives[0], spring);
  for (size_t i = 1; i < drives.size(); ++i) EXPECT_EQ(drives[i].solved_by, "meet");
  const Result<MadeAim> again = makers::MakeAim("meet", made.value().project, nullptr);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.value().project, made.value().project);
}

// Two goals, one on the way to the other.
TEST(Aim, MeetsAPointOnTheWayToAPose) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  const Motion swing = MotionOf(scene.project);
  DynamicsWorkspace ws(scene.figure());
  const MotionFrame& on_the_way = At(10, swing);
  ComputePositions(scene.figure(), on_the_way.X_WR, on_the_way.q, &ws);
  const JointIndex wrist = *scene.figure().FindJoint("r_wrist_deviation");
  const JointIndex shoulder = *scene.figure().FindJoint("r_shoulder_flexion");
  ProjectGoal point = scene.WithPoint("r_wrist", Vec3::Zero(), Vec3::Zero()).goals[0];
  point.position_m = ws.body(wrist).p + 0.1 * (ws.body(shoulder).p - ws.body(wrist).p);
  point.frame = 10;
  project.goals.push_back(point);
  const Result<MadeAim> made = makers::MakeAim("meet", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  const AimReport& report = made.value().report;
  ASSERT_EQ(report.goals.size(), 2u);
  EXPECT_LT(report.goals[0].angle, 0.1 * kDegree);
  EXPECT_LT(report.goals[1].distance, 0.005);
}

// Pose goals of two frames, each to a tenth of a degree.
TEST(Aim, MeetsOnePoseAfterTheOther) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  ProjectGoal early = project.goals[0];
  early.name = "early";
  early.frame = 10;
  const std::vector<double> angles = {70.0, 0.0, 40.0, 90.0, 10.0, 5.0, -5.0};
  for (size_t k = 0; k < angles.size(); ++k) {
    ProjectKey key;
    key.frame = 10;
    key.value = angles[k];
    const std::string& name = scene.figure().joint(scene.hinges()[k]).name;
    PutKey(key, CurveNamed(name, scene.figure(), &project).value());
  }
  project.goals.push_back(early);
  const Result<MadeAim> made = makers::MakeAim("meet", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  for (const makers::GoalMissed& missed : made.value().report.goals) {
    EXPECT_LT(missed.angle, 0.1 * kDegree) << missed.goal;
  }
}

// Two arms of one region, with goals in different frames.
TEST(Aim, MovesTwoArmsToGoalsOfTheirOwn) {
  AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  scene.project.regions[0].joints.push_back({"l_shoulder", true, {}});
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  const Motion swing = MotionOf(scene.project);
  const MotionFrame& then = At(9, swing);
  DynamicsWorkspace ws(scene.figure());
  ComputePositions(scene.figure(), then.X_WR, then.q, &ws);
  const JointIndex wrist = *scene.figure().FindJoint("l_wrist_deviation");
  const JointIndex shoulder = *scene.figure().FindJoint("l_shoulder_flexion");
  ProjectGoal left = scene.WithPoint("l_wrist", Vec3::Zero(), Vec3::Zero()).goals[0];
  left.frame = 9;
  left.position_m = ws.body(wrist).p + 0.2 * (ws.body(shoulder).p - ws.body(wrist).p);
  project.goals.push_back(left);
  const Result<MadeAim> made = makers::MakeAim("touch", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  EXPECT_LT(made.value().report.goals[0].angle, 0.1 * kDegree);
  EXPECT_LT(made.value().report.goals[1].distance, 0.005);
}

// Lengths from one frame to twenty.
TEST(Aim, AimsRegionsOfAnyLength) {
  for (const int last : {6, 7, 8, 25}) {
    AimScene scene("throw.kfa", 5, last, "r_shoulder");
    const Motion swing = MotionOf(scene.project);
    std::vector<double> angles;
    for (const JointIndex j : scene.hinges()) {
      const Joint& joint = scene.figure().joint(j);
      const double angle = At(last, swing).before.q[j.value()];
      const double middle = 0.5 * (joint.lower + joint.upper);
      angles.push_back((angle + 0.05 * (middle - angle)) / kDegree);
    }
    const Result<MadeAim> made = makers::MakeAim("meet", scene.WithPose(angles), nullptr);
    EXPECT_TRUE(made.ok()) << last << ": " << made.error().ToString();
  }
}

TEST(Aim, PushesNoMoreBehindItsLastGoal) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  project.regions[0].last_frame = 20;
  const Result<MadeAim> made = makers::MakeAim("meet", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  for (const ProjectDrive& drive : made.value().project.regions[0].drives) {
    EXPECT_EQ(drive.torque.keys.back().frame, 15.0);
    EXPECT_EQ(drive.torque.keys.back().value, 0.0);
  }
}

// Joints with other drives keep these, and nothing is asked of them.
TEST(Aim, AsksOnlyLimpJoints) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  Project project = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  ProjectDrive spring, empty;
  spring.joints = {{"r_wrist", false, {}}};
  empty.kind = DriveKind::kTorque;
  empty.joints = {{"r_elbow_pronation", false, {}}};
  project.regions[0].drives = {spring, empty};
  const Result<MadeAim> made = makers::MakeAim("meet", project, nullptr);
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  EXPECT_EQ(made.value().project.regions[0].drives.size(), 6u);
}

std::string WhyNot(const std::string& goal, const Project& project) {
  const Result<MadeAim> made = makers::MakeAim(goal, project, nullptr);
  return made.ok() ? "" : made.error().ToString();
}

// 120 points beyond the arm's reach, 80 poses beyond limits.
TEST(Aim, SaysOfTwoHundredGoalsThatTheyCannotBeMet) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  const Figure& figure = scene.figure();
  const MotionFrame end = At(15, MotionOf(scene.project));
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, end.X_WR, end.q, &ws);
  const Vec3 shoulder = ws.body(scene.hinges().front()).p;
  const Vec3 palm(0.0, 0.0, -0.09);
  std::mt19937 random(12);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double longest = 0.0;  // [s]
  const auto refused = [&](const Project& project, const char* name) {
    const auto start = std::chrono::steady_clock::now();
    const Result<MadeAim> made = makers::MakeAim(name, project, scene.animation.figure);
    longest = std::max(
        longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    EXPECT_FALSE(made.ok());
    return made.ok() ? std::string() : made.error().message;
  };
  for (int i = 0; i < 120; ++i) {
    Vec3 away(share(random) - 0.5, share(random) - 0.5, share(random) - 0.5);
    away *= (0.7 + 0.8 * share(random)) / away.norm();
    const std::string text = refused(scene.WithPoint("r_wrist", palm, shoulder + away), "touch");
    EXPECT_NE(text.find("r_wrist comes no nearer than "), std::string::npos) << text;
    // Not nearer than a straight arm.
    const double straight = 0.2751 + 0.2625 + 0.09;
    const double says = std::stod(text.substr(text.find("than ") + 5)) / 100.0;
    EXPECT_GE(says, 0.99 * (away.norm() - straight)) << text;
  }
  for (int i = 0; i < 80; ++i) {
    std::vector<double> angles = scene.RandomPose(&random);
    const size_t k = static_cast<size_t>(share(random) * static_cast<double>(angles.size()));
    const Joint& joint = figure.joint(scene.hinges()[k]);
    angles[k] = joint.upper / kDegree + 1.0 + 50.0 * share(random);
    const std::string text = refused(scene.WithPose(angles), "meet");
    EXPECT_NE(text.find("beyond its limit"), std::string::npos) << text;
  }
  EXPECT_LT(longest, 1.0);
}

TEST(Aim, SaysWhatCannotBeMet) {
  const AimScene scene("throw.kfa", 5, 15, "r_shoulder");
  EXPECT_EQ(WhyNot("meet", scene.WithPose({40.0, -10.0, 20.0, 160.0, 0.0, 0.0, 0.0})),
            "goal: \"meet\" asks r_elbow_flexion to be 10° beyond its limit: change its key in "
            "frame 15");
  // A metre beyond the reach of the arm.
  const Motion swing = MotionOf(scene.project);
  DynamicsWorkspace ws(scene.figure());
  const MotionFrame& there = At(15, swing);
  ComputePositions(scene.figure(), there.X_WR, there.before.q, &ws);
  const Vec3 shoulder = ws.body(*scene.figure().FindJoint("r_shoulder_flexion")).p;
  const double arm = 0.2751 + 0.2625;
  const std::string text = WhyNot(
      "touch", scene.WithPoint("r_wrist", Vec3::Zero(), shoulder + Vec3(arm + 0.12, 0.0, 0.0)));
  EXPECT_EQ(text,
            "goal: \"touch\" is out of reach in frame 15: r_wrist comes no nearer than 12 cm");
  Project early = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  early.goals[0].frame = 4;
  EXPECT_EQ(WhyNot("meet", early),
            "goal: no dynamics region moves r_shoulder_flexion in frame 4: mark one that begins "
            "before it and ends there or later");
  Project sprung = scene.WithPose({40.0, -10.0, 20.0, 60.0, 0.0, 0.0, 0.0});
  ProjectDrive spring;
  spring.joints = {{"r_shoulder", true, {}}};
  sprung.regions[0].drives = {spring};
  EXPECT_EQ(WhyNot("meet", sprung),
            "goal: \"aimed\" leaves no joint of \"meet\" limp: take a drive or friction 0 away "
            "from one");
  EXPECT_EQ(WhyNot("mete", early), "goal: there is no \"mete\"; there is \"meet\"");
}

}  // namespace
}  // namespace hazumi::test
