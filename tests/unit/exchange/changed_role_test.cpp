#include "engine/exchange/import/changed_role.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/exchange/import/import_project.h"
#include "engine/figure/figure_builder.h"
#include "tests/unit/exchange/made_characters.h"
#include "tests/unit/exchange/made_people.h"

namespace hazumi::test {
namespace {

constexpr BodyPlace kLeftForearm = {BodyRole::kForearm, BodySide::kLeft};

// Its left arm bends, turns and twists for 20 frames.
Character MovingPerson() {
  Character person = Person({});
  Clip clip{"clip", 1.0 / 30.0, 20, {}};
  for (const Bone& bone : person.bones) {
    BoneTrack& track = clip.tracks.emplace_back();
    if (!bone.name.starts_with("Left") || bone.name.find("Leg") != std::string::npos) continue;
    for (int f = 0; f < clip.num_frames; ++f) {
      const double t = f / 19.0;
      const Eigen::Quaterniond turn = Eigen::AngleAxisd(-0.8 * t * t, Vec3::UnitY()) *
                                      Eigen::AngleAxisd(0.5 * std::sin(3.0 * t), Vec3::UnitZ()) *
                                      Eigen::AngleAxisd(0.2 * t, Vec3::UnitX());
      track.rotations.push_back(Eigen::Quaterniond(bone.rest.R) * turn);
    }
  }
  person.clips.push_back(std::move(clip));
  return person;
}

// Imported as if nothing told what the left forearm is.
Project WithoutForearm() {
  ImportOptions options;
  options.roles["LeftForeArm"] = {};
  return ImportWell(MovingPerson(), options).project;
}

const JointSpec& JointNamed(const std::string& name, const Project& project) {
  const std::vector<JointSpec>& joints = project.figure.spec.joints;
  return *std::find_if(joints.begin(), joints.end(),
                       [&](const JointSpec& joint) { return joint.name == name; });
}

const ProjectCurve& CurveNamed(const std::string& name, const Project& project) {
  return std::find_if(project.joints.begin(), project.joints.end(),
                      [&](const Named<ProjectCurve>& curve) { return curve.name == name; })
      ->value;
}

// The bodies of all joints in all frames, in the root's frame.
std::vector<Pose> BodiesOf(const Project& project) {
  const Figure figure = BuildFigure(project.figure.spec).value();
  const Motion motion = BakeWell(project);
  DynamicsWorkspace workspace(figure);
  std::vector<Pose> bodies;
  for (const MotionFrame& frame : motion.frames) {
    ComputePositions(figure, Pose(), frame.q, &workspace);
    for (const JointGroup& joint : figure.groups()) {
      const BodyScratch& body = workspace.body(joint.last());
      bodies.push_back({body.R, body.p});
    }
  }
  return bodies;
}

// How far a point 10 cm from a joint, in its body, is apart at most, in all frames [m].
double FarthestApart(const Project& one, const Project& other) {
  const std::vector<Pose> a = BodiesOf(one), b = BodiesOf(other);
  EXPECT_EQ(a.size(), b.size());
  double farthest = 0.0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 p = 0.1 * Vec3::Unit(axis);
      farthest = std::max(farthest, (a[i] * p - b[i] * p).norm());
    }
  }
  return farthest;
}

TEST(ChangedRole, GivesTheHingesThatTheImportWouldHaveGiven) {
  const Project told = ImportWell(MovingPerson()).project;
  Project project = WithoutForearm();
  EXPECT_NE(JointNamed("LeftForeArm", project).hinges[0].name, "flexion");
  const Result<Done> done = ChangeRole("LeftForeArm", kLeftForearm, &project);
  ASSERT_TRUE(done.ok()) << done.error().ToString();
  const JointSpec &now = JointNamed("LeftForeArm", project),
                  &then = JointNamed("LeftForeArm", told);
  EXPECT_EQ(now.body, kLeftForearm);
  ASSERT_EQ(now.hinges.size(), 3u);
  for (size_t h = 0; h < 3; ++h) {
    EXPECT_EQ(now.hinges[h].name, then.hinges[h].name);
    EXPECT_NEAR((now.hinges[h].axis - then.hinges[h].axis).norm(), 0.0, 1e-6);
    EXPECT_NEAR(now.hinges[h].lower, then.hinges[h].lower, 1e-6);
    EXPECT_NEAR(now.hinges[h].upper, then.hinges[h].upper, 1e-6);
    const std::string name = now.NameOf(now.hinges[h]);
    const ProjectCurve &keys = CurveNamed(name, project), &wanted = CurveNamed(name, told);
    ASSERT_EQ(keys.keys.size(), wanted.keys.size() == 1 ? 20u : wanted.keys.size());
    for (size_t k = 0; k < wanted.keys.size(); ++k) {
      EXPECT_NEAR(keys.keys[k].value, wanted.keys[k].value, 1e-4);
    }
  }
}

TEST(ChangedRole, KeepsEveryBodyWhereItIsAtTheKeys) {
  const Project before = WithoutForearm();
  Project after = before;
  ASSERT_TRUE(ChangeRole("LeftForeArm", kLeftForearm, &after).ok());
  EXPECT_LT(FarthestApart(before, after), 1e-7);
}

TEST(ChangedRole, KeepsTheWayBetweenKeysSixFramesApartWithinTwoCentimetres) {
  Project before = WithoutForearm();
  for (Named<ProjectCurve>& curve : before.joints) {
    std::erase_if(curve.value.keys, [](const ProjectKey& key) {
      return key.frame != 0.0 && key.frame != 6.0 && key.frame != 12.0 && key.frame != 19.0;
    });
  }
  Project after = before;
  ASSERT_TRUE(ChangeRole("LeftForeArm", kLeftForearm, &after).ok());
  EXPECT_LT(FarthestApart(before, after), 0.02);
}

TEST(ChangedRole, TakesTheRoleFromTheJointThatHadIt) {
  Project project = ImportWell(MovingPerson()).project;
  ASSERT_TRUE(ChangeRole("LeftHand", kLeftForearm, &project).ok());
  EXPECT_EQ(JointNamed("LeftHand", project).body, kLeftForearm);
  EXPECT_EQ(JointNamed("LeftForeArm", project).body, BodyPlace());
}

TEST(ChangedRole, RefusesWhatCannotBe) {
  Project project = ImportWell(MovingPerson()).project;
  const Project before = project;
  const auto says = [&](const std::string& joint, BodyPlace place) {
    const Result<Done> done = ChangeRole(joint, place, &project);
    EXPECT_FALSE(done.ok());
    EXPECT_EQ(project, before);
    return done.ok() ? "" : done.error().ToString();
  };
  EXPECT_NE(says("Left", kLeftForearm).find("no joint"), std::string::npos);
  EXPECT_NE(says("LeftHand", {BodyRole::kForearm, BodySide::kMiddle}).find("left or right"),
            std::string::npos);
  project = WithoutForearm();
  ProjectRegion region;
  region.name = "arm";
  region.first_frame = 2;
  region.last_frame = 9;
  const JointSpec& forearm = JointNamed("LeftForeArm", project);
  region.joints.push_back({forearm.NameOf(forearm.hinges[0]), false, {}});
  project.regions.push_back(region);
  const Result<Done> done = ChangeRole("LeftForeArm", kLeftForearm, &project);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().ToString().find("regions[0]"), std::string::npos)
      << done.error().ToString();
}

}  // namespace
}  // namespace hazumi::test
