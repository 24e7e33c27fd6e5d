#include "engine/project/compile.h"

#include <gtest/gtest.h>

#include <functional>

#include "engine/figure/figure_builder.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

Compiled CompileGood(const Changes& changes = {}) {
  Result<Compiled> compiled = CompileAnimation(ParseGood(Changed(SampleProject(), changes)));
  if (!compiled.ok()) ADD_FAILURE() << compiled.error().ToString();
  return std::move(compiled).value();
}

std::vector<std::string> JointNames(const Animation& animation, const DynamicsRegion& region) {
  std::vector<std::string> names;
  for (JointIndex j : region.joints) names.push_back(animation.figure->joint(j).name);
  return names;
}

TEST(CompileAnimation, ConvertsToRadiansAndKeepsMetres) {
  const Animation animation = CompileGood().animation;
  const auto knee = animation.figure->FindJoint("r_knee");
  const Keys& keys = animation.joint_keys[knee->value()];
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_DOUBLE_EQ(keys[0].value, 12 * kDegree);
  EXPECT_DOUBLE_EQ(*keys[0].rate, 30 * kDegree);
  EXPECT_EQ(keys[0].interpolation, Interpolation::kLinear);
  EXPECT_EQ(keys[1].frame, 2.5);
  EXPECT_FALSE(keys[1].rate.has_value());
  EXPECT_DOUBLE_EQ(animation.root_keys[kRootZ][0].value, 0.9);
  EXPECT_DOUBLE_EQ(*animation.root_keys[kRootZ][0].rate, 0.1);
  EXPECT_DOUBLE_EQ(animation.root_keys[kRootAngleZ][0].value, 90 * kDegree);
  EXPECT_EQ(animation.gravity, 9.8);
}

TEST(CompileAnimation, ResolvesTheJointsOfARegion) {
  const Compiled compiled = CompileGood();
  const DynamicsRegion& arm = compiled.animation.regions[0];
  // Beyond l_shoulder includes it; its fixed twist is left out with a warning.
  EXPECT_EQ(JointNames(compiled.animation, arm),
            (std::vector<std::string>{"r_elbow", "r_wrist_flexion", "r_wrist_deviation",
                                      "l_shoulder_flexion", "l_shoulder_abduction", "l_elbow",
                                      "l_wrist_flexion", "l_wrist_deviation"}));
  // A hinge's own factor goes before its group's, that before the default.
  EXPECT_EQ(arm.friction, (std::vector<double>{0.8, 0.3, 0.4, 0.8, 0.8, 0.8, 0.8, 0.8}));
  EXPECT_EQ(arm.step, 0.01);
  EXPECT_FALSE(compiled.animation.regions[1].step.has_value());
  ASSERT_EQ(compiled.warnings.size(), 1u);
  EXPECT_EQ(compiled.warnings[0].place, "regions[0].joints");
}

TEST(CompileAnimation, PlusBehindAJoint_MeansAllBeyondIt) {
  const auto joints = [](const char* refs) {
    return CompileGood({{"/regions/0/joints", refs},
                        {"/regions/0/method", "\"exact\""},
                        {"/regions/0/friction/joints", "{}"}})
        .animation.regions[0]
        .joints;
  };
  EXPECT_EQ(joints(R"(["r_elbow+"])"), joints(R"([{"beyond": "r_elbow"}])"));
  EXPECT_EQ(joints(R"(["pelvis+"])"), joints(R"([{"beyond": "pelvis"}])"));
  EXPECT_GT(joints(R"(["r_elbow+"])").size(), joints(R"(["r_elbow"])").size());
}

TEST(CompileAnimation, DriveBeyondTheRoot_DrivesTheJointsOfItsRegion) {
  for (const char* root : {R"({"beyond": "pelvis"})", R"("pelvis+")", R"({"beyond": "root"})"}) {
    const Animation animation =
        CompileGood({{"/regions/0/drives", std::string("[{\"joints\": [") + root +
                                               R"(], "kind": "spring", "frequency_hz": 2}])"}})
            .animation;
    ASSERT_EQ(animation.regions[0].drives.size(), 1u);
    EXPECT_EQ(animation.regions[0].drives[0].joints, animation.regions[0].joints) << root;
  }
}

TEST(JointNames, JointWhoseOwnNameEndsWithPlus_GoesBeforeAllBeyond) {
  LinkSpec link;
  link.name = "rod";
  link.to = Vec3::UnitZ();
  link.radius = 0.1;
  link.mass = 1.0;
  const auto hinged = [&](const char* name) {
    JointSpec joint;
    joint.name = name;
    joint.parent = "hips";
    joint.links = {link};
    joint.hinges = {{"", Vec3::UnitX(), -1.0, 1.0, 0.0}};
    return joint;
  };
  FigureSpec spec;
  spec.root_name = "hips";
  spec.root_links = {link};
  spec.joints = {hinged("arm+"), hinged("leg")};
  const Figure figure = BuildFigure(spec).value();
  const JointRef arm = Meant({"arm+", false, {}}, figure);
  const JointRef leg = Meant({"leg+", false, {}}, figure);
  EXPECT_EQ(arm.name, "arm+");
  EXPECT_FALSE(arm.beyond);
  EXPECT_EQ(leg.name, "leg");
  EXPECT_TRUE(leg.beyond);
}

TEST(CompileAnimation, WhatTouchesTheSceneAndHowRoughThatIs) {
  const Animation plain = CompileGood().animation;
  EXPECT_FALSE(plain.regions[0].touches_scene);
  EXPECT_EQ(plain.scene[0].friction, 0.8);
  Changes changes = {{"/solver/method", "\"exact\""},
                     {"/regions/0/method", "\"exact\""},
                     {"/regions/0/contacts", R"({"scene": true})"},
                     {"/scene/objects/1/friction_coefficient", "0"}};
  const Animation animation = CompileGood(changes).animation;
  EXPECT_TRUE(animation.regions[0].touches_scene);
  EXPECT_FALSE(animation.regions[1].touches_scene);
  EXPECT_EQ(animation.scene[0].friction, 0.8);
  EXPECT_EQ(animation.scene[1].friction, 0.0);
  changes.emplace_back("/regions/0/mute", "true");
  EXPECT_FALSE(CompileGood(changes).animation.regions[0].touches_scene);
}

// Joints that their keys drive are none of the region's; the others keep their friction.
TEST(CompileAnimation, ResolvesTheDrivesOfARegion) {
  const Animation animation = CompileGood({{"/regions/0/drives",
                                            R"([{"joints": ["r_wrist"], "kind": "keys"},
                        {"joints": [{"beyond": "l_elbow"}], "kind": "spring", "frequency_hz": 3,
                         "damping_ratio": 0.5, "to": "start", "max_torque_n_m": 7},
                        {"joints": ["r_elbow"], "kind": "torque",
                         "keys": [{"frame": 5, "torque_n_m": 1.5}]}])"}})
                                  .animation;
  const DynamicsRegion& arm = animation.regions[0];
  EXPECT_EQ(JointNames(animation, arm),
            (std::vector<std::string>{"r_elbow", "l_shoulder_flexion", "l_shoulder_abduction",
                                      "l_elbow", "l_wrist_flexion", "l_wrist_deviation"}));
  EXPECT_EQ(arm.friction, std::vector<double>(6, 0.8));
  ASSERT_EQ(arm.keyed.size(), 2u);
  EXPECT_EQ(animation.figure->joint(arm.keyed[0]).name, "r_wrist_flexion");
  ASSERT_EQ(arm.drives.size(), 2u);
  const Drive &spring = arm.drives[0], &torque = arm.drives[1];
  EXPECT_EQ(spring.joints.size(), 3u);
  EXPECT_EQ(spring.target, SpringTarget::kStart);
  EXPECT_EQ(spring.frequency, 3.0);
  EXPECT_EQ(spring.damping_ratio, 0.5);
  EXPECT_EQ(spring.max_torque, 7.0);
  ASSERT_EQ(torque.torque.size(), 1u);
  EXPECT_EQ(torque.torque[0].value, 1.5);
}

// A region of nothing else moves nothing, and is none that was forgotten to be filled.
TEST(CompileAnimation, ARegionMayBeKeyedAsAWhole) {
  const Animation animation =
      CompileGood({{"/regions/1/drives", R"([{"joints": ["r_knee"], "kind": "keys"}])"}}).animation;
  EXPECT_TRUE(animation.regions[1].moves_nothing());
  EXPECT_FALSE(animation.regions[1].is_muted);
}

TEST(CompileAnimation, TakesStepAndToleranceFromTheRegionElseTheSolverElseTheDefault) {
  const Animation stated = CompileGood({{"/solver/tolerance_deg", "0.2"}}).animation;
  EXPECT_DOUBLE_EQ(stated.solver.tolerance, 0.2 * kDegree);
  EXPECT_DOUBLE_EQ(*stated.regions[0].tolerance, 0.5 * kDegree);
  EXPECT_FALSE(stated.regions[1].tolerance.has_value());
  const Animation bare = CompileGood({{"/solver/step_s", ""}}).animation;
  EXPECT_EQ(bare.solver.step, 1.0 / 30.0);
  EXPECT_DOUBLE_EQ(bare.solver.tolerance, 0.01 * kDegree);
}

// One region of method exact with these joints.
Animation CompileExact(const std::string& joints) {
  const std::string region = R"({"name": "r", "first_frame": 5, "last_frame": 9, "joints": )";
  return CompileGood({{"/solver/method", "\"exact\""}, {"/regions", "[" + region + joints + "}]"}})
      .animation;
}

TEST(CompileAnimation, ARegionMayNameTheRoot) {
  const Animation named = CompileExact(R"(["r_elbow", "pelvis"])");
  EXPECT_TRUE(named.regions[0].root);
  EXPECT_EQ(JointNames(named, named.regions[0]), std::vector<std::string>{"r_elbow"});
  const Animation alone = CompileExact(R"(["root"])");
  EXPECT_TRUE(alone.regions[0].root);
  EXPECT_TRUE(alone.regions[0].joints.empty());
  EXPECT_FALSE(CompileExact(R"(["waist"])").regions[0].root);
}

TEST(CompileAnimation, BeyondTheRootIsEveryJointThatCanMove) {
  const Animation animation = CompileExact(R"([{"beyond": "root"}])");
  const DynamicsRegion& region = animation.regions[0];
  EXPECT_TRUE(region.root);
  size_t movable = 0;
  for (const Joint& joint : animation.figure->joints()) movable += joint.is_fixed() ? 0 : 1;
  EXPECT_EQ(region.joints.size(), movable);
  EXPECT_EQ(region.friction, std::vector<double>(movable, 1.0));
}

TEST(CompileAnimation, FrictionMayFreezeAWholeRegion) {
  const Changes frozen = {{"/regions/1/friction/default", "0"}};
  EXPECT_EQ(CompileGood(frozen).animation.regions[1].friction, std::vector<double>{0.0});
}

TEST(CompileAnimation, RegionsOfBothMethodsMayTouch) {
  const Changes changes = {{"/solver/method", "\"exact\""}, {"/regions/1/method", "\"exact\""}};
  const Animation animation = CompileGood(changes).animation;
  EXPECT_EQ(animation.regions[0].method, Method::kPaper);
  EXPECT_EQ(animation.regions[1].method, Method::kExact);
}

TEST(CompileAnimation, SortsPlacementsAndResolvesPins) {
  const Animation animation = CompileGood().animation;
  ASSERT_EQ(animation.placements.size(), 3u);
  EXPECT_EQ(animation.placements[0].kind, PlacementKind::kKeyed);
  EXPECT_FALSE(animation.placements[0].pin.has_value());
  EXPECT_EQ(animation.placements[1].pin, animation.figure->FindGroup("l_ankle"));
  EXPECT_EQ(animation.placements[2].pin, animation.figure->FindGroup("r_ankle"));
  EXPECT_EQ(animation.placements[2].landing_pin, animation.figure->FindGroup("l_ankle"));
  EXPECT_TRUE(animation.holds[0].hold_orientation);
}

TEST(CompileAnimation, HalvesSizesAndTurnsBoxes) {
  const Animation animation = CompileGood().animation;
  const Box& platform = std::get<Box>(animation.scene[1].shape);
  EXPECT_EQ(platform.half_size, Vec3(0.5, 0.5, 0.1));
  EXPECT_TRUE((platform.X_WB.R * Vec3::UnitX()).isApprox(Vec3::UnitY()));
  const HeldObject& brick = animation.held_objects[1];
  EXPECT_EQ(std::get<BoxShape>(brick.shape).half_size, Vec3(0.1, 0.05, 0.025));
  EXPECT_FALSE(brick.holders[0].last_frame.has_value());
  // A hinge's name means its group.
  EXPECT_EQ(animation.held_objects[0].holders[0].joint, animation.figure->FindGroup("r_wrist"));
}

// A scene's object stays where it is; a held one goes with its holder's body, in whose frame its
// centre is and its axes are turned.
TEST(CompileAnimation, EndsOfConstraintsAreFixedToBodiesOrInTheWorld) {
  const Animation animation = CompileGood({{"/solver/method", "\"exact\""},
                                           {"/regions/0/method", "\"exact\""},
                                           {"/held_objects/1/offset_m", "[0, 0, -0.1]"},
                                           {"/held_objects/1/rotation_deg", "[0, 90, 0]"},
                                           {"/constraints", R"([
      {"name": "grip", "kind": "point", "a": {"joint": "r_wrist_flexion", "offset_m": [1, 2, 3]},
       "b": {"object": "platform", "offset_m": [0, 0.2, 0]}, "first_frame": 5, "last_frame": 15,
       "arrive_frames": 4, "break_force_n": 900},
      {"name": "glue", "kind": "weld", "a": {"object": "brick", "offset_m": [0, 0, 0.5]},
       "b": {"joint": "root", "rotation_deg": [90, 0, 0]}, "first_frame": 5, "last_frame": 15},
      {"name": "rope", "kind": "distance", "a": {"joint": "l_elbow"}, "b": {"object": "ground",
       "offset_m": [0, 0, 2]}, "length_m": 0.3, "first_frame": 5, "last_frame": 15}])"}})
                                  .animation;
  ASSERT_EQ(animation.constraints.size(), 3u);
  const auto group = [&](const char* name) { return animation.figure->FindGroup(name); };
  const Constraint& grip = animation.constraints[0];
  EXPECT_EQ(grip.a, (ConstraintEnd{false, group("r_wrist"), Vec3(1, 2, 3), Mat3::Identity(), {}}));
  EXPECT_TRUE(grip.b.is_in_world);
  EXPECT_TRUE(grip.b.offset.isApprox(Vec3(-0.2, 0, 0.1), 1e-12));
  EXPECT_EQ(grip.arrive_frames, 4);
  EXPECT_EQ(grip.break_force, 900.0);
  EXPECT_EQ(grip.break_impulse, std::nullopt);
  const Constraint& glue = animation.constraints[1];
  const auto turned = [](const Vec3& axis) {
    return Eigen::AngleAxisd(90 * kDegree, axis).toRotationMatrix();
  };
  EXPECT_EQ(glue.a.joint, group("l_wrist"));
  EXPECT_TRUE(glue.a.offset.isApprox(Vec3(0.5, 0, -0.1), 1e-12));
  EXPECT_TRUE(glue.a.rotation.isApprox(turned(Vec3::UnitY()), 1e-12));
  EXPECT_EQ(glue.b.joint, std::nullopt);
  EXPECT_FALSE(glue.b.is_in_world);
  EXPECT_TRUE(glue.b.rotation.isApprox(turned(Vec3::UnitZ()), 1e-12));
  EXPECT_EQ(animation.constraints[2].b.offset, Vec3(0, 0, 2));
  EXPECT_EQ(animation.constraints[2].length, 0.3);
}

TEST(CompileAnimation, SpansMayTouch) {
  const Changes changes = {{"/regions/1/joints", R"(["r_elbow"])"}};
  EXPECT_EQ(CompileGood(changes).animation.regions[1].joints.size(), 1u);
}

TEST(CompileAnimation, PutsTheWarningsOfReadingFirst) {
  const Compiled compiled = CompileGood({{"/regions/0/step", "0.01"}});
  ASSERT_EQ(compiled.warnings.size(), 2u);
  EXPECT_EQ(compiled.warnings[0].place, "regions[0]");
  EXPECT_EQ(compiled.warnings[1].place, "regions[0].joints");
}

TEST(CompileAnimation, AnEmptyProjectRests) {
  const Changes changes = {{"/scene", ""},        {"/root", ""},       {"/joints", ""},
                           {"/regions", ""},      {"/placements", ""}, {"/holds", ""},
                           {"/held_objects", ""}, {"/camera", ""},     {"/name", ""}};
  const Compiled compiled = CompileGood(changes);
  EXPECT_EQ(compiled.animation.gravity, 9.81);
  EXPECT_EQ(compiled.animation.joint_keys.size(),
            static_cast<size_t>(compiled.animation.figure->num_joints()));
  EXPECT_TRUE(compiled.warnings.empty());
}

// What an editor may come to hold and no file can: saved, it could not be read back.
TEST(CompileAnimation, RefusesWhatCouldNotBeReadBack) {
  static constexpr int kWhole = 2'000'000'000;
  static constexpr double kLarge = 2e9;
  const std::vector<std::function<void(Project*)>> changes = {
      [](Project* p) {
        p->fps = {kWhole, kWhole / 30, {}};
      },
      [](Project* p) { p->frames.last = kWhole; },
      [](Project* p) { p->frames.first = -kWhole; },
      [](Project* p) { p->preview->last = kWhole; },
      [](Project* p) { p->scene.gravity_m_s2 = kLarge; },
      [](Project* p) { p->joints[0].value.keys.back().value = kLarge; },
      [](Project* p) { p->regions[0].last_frame = kWhole; },
      [](Project* p) { p->regions[0].blend_frames = kWhole; },
      [](Project* p) { p->placements[0].last_frame = kWhole; },
      [](Project* p) { p->holds[0].last_frame = kWhole; },
      [](Project* p) { p->markers[0].frame = kWhole; },
      [](Project* p) { p->held_objects[0].mass_kg = kLarge; },
      [](Project* p) { p->held_objects[0].release_frame = kWhole; },
      [](Project* p) {
        p->held_objects[0].shape = ProjectSphereShape{kLarge, {}};
      },
      [](Project* p) {
        p->held_objects[0].shape = ProjectBoxShape{{kLarge, 1, 1}, {}};
      },
      [](Project* p) { p->camera->eye_m.x() = kLarge; },
  };
  for (size_t i = 0; i < changes.size(); ++i) {
    Project project = ParseGood(SampleProject());
    changes[i](&project);
    EXPECT_FALSE(ParseProject(WriteProject(project), "a.kfa").ok()) << i;
    const Result<Compiled> compiled = CompileAnimation(project);
    ASSERT_FALSE(compiled.ok()) << i;
    EXPECT_EQ(compiled.error().code, ErrorCode::kSchema) << i << compiled.error().ToString();
  }
}

}  // namespace
}  // namespace hazumi::testing
