// What the parts of imported people weigh. The shares are the table's, the bones of each told apart
// by hand (mass_oracle.h), not by the importer.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/exchange/import/import_project.h"
#include "engine/figure/figure_builder.h"
#include "tests/unit/exchange/made_characters.h"
#include "tests/unit/exchange/made_people.h"
#include "tests/unit/exchange/mass_oracle.h"

namespace hazumi::test {
namespace {

constexpr double kPoint = 0.2;  // percentage points

FigureSpec FigureOf(const Character& character) {
  return ImportWell(character).project.figure.spec;
}

void ExpectTable(const FigureSpec& figure, const std::string& what) {
  const std::map<std::string, double> shares = SharesOf(figure);
  double sum = 0.0;
  for (const auto& [segment, share] : shares) {
    sum += share;
    ASSERT_TRUE(kDeLeva.contains(segment)) << what << ": " << segment;
    EXPECT_NEAR(share, kDeLeva.at(segment), kPoint) << what << ": " << segment;
  }
  EXPECT_EQ(shares.size(), kDeLeva.size()) << what;
  EXPECT_NEAR(sum, 100.0, 1e-9) << what;
}

std::vector<PersonBones> EveryBuild() {
  std::vector<PersonBones> builds;
  for (int spine = 1; spine <= 6; ++spine) {
    for (int necks = 0; necks <= 2; ++necks) {
      for (int bits = 0; bits < 64; ++bits) {
        PersonBones bones;
        bones.spine = spine;
        bones.necks = necks;
        bones.collars = bits & 1;
        bones.hip_joints = bits & 2;
        bones.twists = bits & 4;
        bones.fingers = bits & 8;
        bones.toes = bits & 16;
        bones.stacked = bits & 32;
        builds.push_back(bones);
      }
    }
  }
  return builds;
}

std::string TextOf(const PersonBones& b) {
  return std::to_string(b.spine) + " spine, " + std::to_string(b.necks) + " neck" +
         (b.collars ? ", collars" : "") + (b.hip_joints ? ", hip joints" : "") +
         (b.twists ? ", twists" : "") + (b.fingers ? ", fingers" : "") + (b.toes ? ", toes" : "") +
         (b.stacked ? ", stacked" : "");
}

// The height of the standing figure's centre of mass, of its stature.
double HeightOfCom(const FigureSpec& spec) {
  const Figure figure = BuildFigure(spec).value();
  DynamicsWorkspace ws(figure);
  Pose root;
  root.p.z() = 0.5508 * kPersonHeight;
  const VecX q = VecX::Zero(figure.num_joints());
  ComputePositions(figure, root, q, &ws);
  return CenterOfMass(figure, ws).z() / kPersonHeight;
}

TEST(MassShares, AreTheTablesForEveryBuildOfASkeleton) {
  for (const PersonBones& bones : EveryBuild()) {
    ExpectTable(FigureOf(Person(bones)), TextOf(bones));
    if (HasFailure()) return;
  }
}

// Standing men's centres of mass are at 55 to 57 % of their height (the shipped human's: 56.7).
TEST(MassShares, PutTheCentreOfMassWhereStandingMenHaveIt) {
  for (const PersonBones& bones : EveryBuild()) {
    if (bones.stacked) continue;  // its shoulders hang too low
    const double height = HeightOfCom(FigureOf(Person(bones)));
    EXPECT_GT(height, 0.55) << TextOf(bones);
    EXPECT_LT(height, 0.57) << TextOf(bones);
  }
}

TEST(MassShares, NeitherCollarsNorHipJointsAreHeavy) {
  PersonBones bones;
  bones.hip_joints = true;
  for (bones.spine = 1; bones.spine <= 6; ++bones.spine) {
    for (const JointSpec& joint : FigureOf(Person(bones)).joints) {
      const bool is_girdle = joint.name.ends_with("Shoulder") || joint.name.ends_with("HipJoint");
      double share = 0.0;
      for (const LinkSpec& link : joint.links) share += *link.mass / (70.0 / (1.7 * 1.7));
      if (is_girdle) {
        EXPECT_LT(share, 0.06 * 1.7 * 1.7) << joint.name << ", " << bones.spine;
      }
    }
  }
}

TEST(MassShares, ThighsHangOnTheirJointsAsTheTableSays) {
  const FigureSpec figure = FigureOf(Person({}));
  for (const JointSpec& joint : figure.joints) {
    if (!joint.name.ends_with("UpLeg")) continue;
    ASSERT_EQ(joint.links.size(), 1u);
    const LinkSpec& link = joint.links[0];
    EXPECT_NEAR(link.com->norm() / link.to.norm(), 0.4095, 1e-3);
  }
}

using Names = std::vector<std::pair<std::string, std::string>>;

const Names kByJoint = {{"LeftShoulder", "LeftCollar"}, {"RightShoulder", "RightCollar"},
                        {"LeftArm", "LeftShoulder"},    {"RightArm", "RightShoulder"},
                        {"LeftForeArm", "LeftElbow"},   {"RightForeArm", "RightElbow"},
                        {"LeftHand", "LeftWrist"},      {"RightHand", "RightWrist"},
                        {"LeftUpLeg", "LeftHip"},       {"RightUpLeg", "RightHip"},
                        {"LeftLeg", "LeftKnee"},        {"RightLeg", "RightKnee"},
                        {"LeftFoot", "LeftAnkle"},      {"RightFoot", "RightAnkle"}};
const Names kRigify = {
    {"LeftShoulder", "shoulder.L"}, {"RightShoulder", "shoulder.R"}, {"LeftArm", "upper_arm.L"},
    {"RightArm", "upper_arm.R"},    {"LeftForeArm", "forearm.L"},    {"RightForeArm", "forearm.R"},
    {"LeftHand", "hand.L"},         {"RightHand", "hand.R"},         {"LeftUpLeg", "thigh.L"},
    {"RightUpLeg", "thigh.R"},      {"LeftLeg", "shin.L"},           {"RightLeg", "shin.R"},
    {"LeftFoot", "foot.L"},         {"RightFoot", "foot.R"}};
const Names kUnreal = {{"Hips", "pelvis"},
                       {"LeftShoulder", "clavicle_l"},
                       {"LeftArm", "upperarm_l"},
                       {"RightShoulder", "clavicle_r"},
                       {"RightArm", "upperarm_r"},
                       {"LeftForeArm", "lowerarm_l"},
                       {"RightForeArm", "lowerarm_r"},
                       {"LeftForeArmRoll", "lowerarm_twist_01_l"},
                       {"LeftHand", "hand_l"},
                       {"RightHand", "hand_r"},
                       {"LeftUpLeg", "thigh_l"},
                       {"RightUpLeg", "thigh_r"},
                       {"LeftUpLegRoll", "thigh_twist_01_l"},
                       {"LeftLeg", "calf_l"},
                       {"RightLeg", "calf_r"},
                       {"LeftFoot", "foot_l"},
                       {"RightFoot", "foot_r"},
                       {"LeftToeBase", "ball_l"},
                       {"RightToeBase", "ball_r"},
                       {"Neck", "neck_01"}};

// The same bones by other names weigh the same.
void ExpectSame(const Character& person, const Names& names) {
  const FigureSpec named = FigureOf(person), renamed = FigureOf(Renamed(person, names));
  ASSERT_EQ(named.joints.size(), renamed.joints.size());
  for (size_t j = 0; j < named.joints.size(); ++j) {
    ASSERT_EQ(named.joints[j].links.size(), renamed.joints[j].links.size());
    for (size_t i = 0; i < named.joints[j].links.size(); ++i) {
      EXPECT_NEAR(*named.joints[j].links[i].mass, *renamed.joints[j].links[i].mass, 1e-12)
          << renamed.joints[j].name;
    }
  }
}

TEST(MassShares, AreTheTablesHoweverARigCallsItsBones) {
  PersonBones bones;
  ExpectSame(Person(bones), kByJoint);
  ExpectSame(Person(bones), kRigify);
  bones.twists = bones.fingers = true;
  ExpectSame(Person(bones), kUnreal);
  bones = {};
  bones.collars = false;
  Names without_collars;
  for (const auto& [from, to] : kByJoint) {
    if (!from.ends_with("Shoulder")) without_collars.emplace_back(from, to);
  }
  ExpectSame(Person(bones), without_collars);
}

// "arm_1", "arm_2", "arm_3": which is which their order says.
TEST(MassShares, LimbsWhoseBonesAreAllCalledTheSameAreTakenInTheirOrder) {
  PersonBones bones;
  bones.toes = bones.collars = false;
  Names names;
  for (const std::string side : {"Left", "Right"}) {
    int i = 1;
    for (const char* bone : {"Arm", "ForeArm", "Hand"}) {
      names.push_back({side + bone, "arm_joint_" + side.substr(0, 1) + "_" + std::to_string(i++)});
    }
    i = 1;
    for (const char* bone : {"UpLeg", "Leg", "Foot"}) {
      names.push_back({side + bone, "leg_joint_" + side.substr(0, 1) + "_" + std::to_string(i++)});
    }
  }
  ExpectSame(Person(bones), names);
}

TEST(MassShares, WhatHangsOnAPartIsAPartOfIt) {
  Character character = Person({});
  Hang("sword", "RightHand", Vec3(0.0, 0.0, -0.9), &character);
  Hang("cape", "Spine2", Vec3(-0.2, 0.0, -0.8), &character);
  Hang("jiggle.L", "LeftUpLeg", Vec3(-0.1, 0.0, -0.1), &character);
  ExpectTable(FigureOf(character), "sword, cape");
}

TEST(MassShares, WithoutASegmentTheOthersKeepTheirRatios) {
  PersonBones bones;
  bones.hands = false;
  const Imported imported = ImportWell(Person(bones));
  for (const auto& [segment, share] : SharesOf(imported.project.figure.spec)) {
    EXPECT_NEAR(share, kDeLeva.at(segment) / (1.0 - 0.0122), 1e-9) << segment;
  }
  const std::string fact = "kg, as de Leva's table of men has them without hands";
  const auto& facts = imported.report.facts;
  EXPECT_TRUE(std::any_of(facts.begin(), facts.end(),
                          [&](const std::string& f) { return f.ends_with(fact); }));
}

// A closed box of a bone that nothing names.
void AddBox(const Vec3& low, const Vec3& high, int bone, Character* character) {
  SkinMesh mesh;
  Eigen::Matrix4d to_bone = Eigen::Matrix4d::Identity();
  for (int b = bone; b >= 0; b = character->bones[b].parent) {
    to_bone.topRightCorner<3, 1>() -= character->bones[b].rest.p;
  }
  mesh.binds.push_back({bone, to_bone});
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = (corner >> i) & 1 ? high[i] : low[i];
    mesh.positions.push_back(p.cast<float>());
    mesh.normals.push_back(Eigen::Vector3f::UnitZ());
    mesh.bind_indices.push_back({0, 0, 0, 0});
    mesh.weights.push_back({1.0f, 0.0f, 0.0f, 0.0f});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  character->meshes.push_back(std::move(mesh));
}

Character TwoLinks() {
  Character character;
  character.up = UpAxis::kZ;
  character.metres_per_unit = 1.0;
  for (int b = 0; b < 2; ++b) {
    Bone bone;
    bone.name = b == 0 ? "base" : "lever";
    bone.parent = b - 1;
    bone.rest.p = Vec3(0, 0, b);
    character.bones.push_back(bone);
  }
  return character;
}

std::vector<double> MassesOf(const FigureSpec& figure) {
  std::vector<double> masses(1);
  for (const LinkSpec& link : figure.root_links) masses[0] += *link.mass;
  for (const JointSpec& joint : figure.joints) {
    masses.push_back(0.0);
    for (const LinkSpec& link : joint.links) masses.back() += *link.mass;
  }
  return masses;
}

TEST(MassShares, OfWhatIsNobodyAreThoseOfTheMeshsVolume) {
  Character character = TwoLinks();
  AddBox(Vec3(-0.2, -0.2, 0.0), Vec3(0.2, 0.2, 1.0), 0, &character);  // 0.16 m^3
  AddBox(Vec3(-0.1, -0.1, 1.0), Vec3(0.1, 0.1, 2.0), 1, &character);  // 0.04 m^3
  const std::vector<double> masses = MassesOf(FigureOf(character));
  ASSERT_EQ(masses.size(), 2u);
  EXPECT_NEAR(masses[0] / masses[1], 4.0, 1e-5);
  for (SkinMesh& mesh : character.meshes) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  }
  const std::vector<double> inside_out = MassesOf(FigureOf(character));
  EXPECT_NEAR(inside_out[0] / inside_out[1], 4.0, 1e-5);
}

// Cubes of the same volume on hips and head, and next to nothing on other bones: the head weighs
// half, all else is as the table has it.
TEST(MassShares, ABigHeadWeighsWhatItsVolumeSays) {
  Character person = Person({});
  const std::map<std::string, double> usual = SharesOf(FigureOf(person));
  for (size_t b = 0; b < person.bones.size(); ++b) {
    const std::string& name = person.bones[b].name;
    const double half = name == "Hips" || name == "Head" ? 0.2 : 1e-3;
    AddBox(Vec3::Constant(-half), Vec3::Constant(half), static_cast<int>(b), &person);
  }
  std::map<std::string, double> shares = SharesOf(FigureOf(person));
  EXPECT_NEAR(shares.at("head and neck"), 50.0, kPoint);
  for (const auto& [segment, share] : usual) {
    if (segment == "head and neck") continue;
    const double expected = share * 50.0 / (100.0 - usual.at("head and neck"));
    EXPECT_NEAR(shares.at(segment), expected, kPoint) << segment;
  }
}

// One closed skin over both bones, with a cap where the second one begins.
TEST(MassShares, AClosedSkinsVolumeIsSharedOutByItsWeights) {
  Character character = TwoLinks();
  AddBox(Vec3(-0.2, -0.2, 0.0), Vec3(0.2, 0.2, 1.5), 0, &character);
  SkinMesh& mesh = character.meshes[0];
  Eigen::Matrix4d to_lever = Eigen::Matrix4d::Identity();
  to_lever(2, 3) = -1.0;
  mesh.binds.push_back({1, to_lever});
  for (size_t v = 4; v < 8; ++v) mesh.bind_indices[v] = {1, 0, 0, 0};
  const std::vector<double> masses = MassesOf(FigureOf(character));
  const double sides = 4.0 * 0.4 * 1.5 * 0.2 / 2.0;  // of x . n dA, to each bone half of it
  const double base = (sides + 0.16 * 1.0) / 3.0;    // and its cap; its floor is at 0
  const double lever = (sides + 0.16 * 1.5 - 0.16 * 1.0) / 3.0;
  EXPECT_NEAR(masses[0] / (masses[0] + masses[1]), base / (base + lever), 1e-5);
  EXPECT_NEAR(base + lever, 0.4 * 0.4 * 1.5, 1e-12);
}

}  // namespace
}  // namespace hazumi::test
