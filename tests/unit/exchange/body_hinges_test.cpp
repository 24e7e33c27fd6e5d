// Hinges of imported bodies: the same ones whatever the axes of the file's bones are.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/spatial/degrees.h"
#include "tests/support/random.h"
#include "tests/unit/exchange/made_characters.h"
#include "tests/unit/exchange/made_people.h"

namespace hazumi::test {
namespace {

constexpr double kRaised = 70.0, kBent = 30.0;  // arms at rest [deg]

std::vector<Pose> WorldOf(const Character& character) {
  std::vector<Pose> X_W;
  for (const Bone& bone : character.bones) {
    X_W.push_back(bone.parent < 0 ? bone.rest : X_W[static_cast<size_t>(bone.parent)] * bone.rest);
  }
  return X_W;
}

// Bones that lie there in the world.
void Lay(const std::vector<Pose>& X_W, Character* character) {
  for (size_t b = 0; b < X_W.size(); ++b) {
    Bone& bone = character->bones[b];
    bone.rest = bone.parent < 0 ? X_W[b] : X_W[static_cast<size_t>(bone.parent)].Inverse() * X_W[b];
  }
}

// Turns a bone about an axis of the world through its origin, with all that hangs on it.
void Turn(const std::string& name, double degrees, const Vec3& axis, Character* character) {
  std::vector<Pose> X_W = WorldOf(*character);
  std::vector<char> is_beyond(X_W.size(), 0);
  const Mat3 R = Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
  Vec3 about = Vec3::Zero();
  for (size_t b = 0; b < X_W.size(); ++b) {
    const Bone& bone = character->bones[b];
    const bool is_it = bone.name == name;
    if (is_it) about = X_W[b].p;
    is_beyond[b] = is_it || (bone.parent >= 0 && is_beyond[static_cast<size_t>(bone.parent)]);
    if (is_beyond[b]) X_W[b] = {R * X_W[b].R, about + R * (X_W[b].p - about)};
  }
  Lay(X_W, character);
}

// Arms raised sideways, elbows bent forward.
Character WithRaisedArms() {
  Character person = Person({});
  Turn("LeftArm", kRaised, Vec3::UnitX(), &person);
  Turn("RightArm", -kRaised, Vec3::UnitX(), &person);
  const auto bend = [&](const std::string& name, double side) {
    const double a = side * kRaised * kDegree;
    Turn(name, -kBent, Vec3(0.0, std::cos(a), std::sin(a)), &person);
  };
  bend("LeftForeArm", 1.0);
  bend("RightForeArm", -1.0);
  return person;
}

const HingeSpec* Find(const std::string& joint, const std::string& hinge, const FigureSpec& spec) {
  for (const JointSpec& other : spec.joints) {
    for (const HingeSpec& of : other.hinges) {
      if (other.name == joint && of.name == hinge) return &of;
    }
  }
  ADD_FAILURE() << joint << " has no " << hinge;
  return nullptr;
}

TEST(BodyHinges, AnglesAreZeroWhereTheBodyStands) {
  const FigureSpec spec = ImportWell(WithRaisedArms()).project.figure.spec;
  for (const std::string side : {"Left", "Right"}) {
    EXPECT_NEAR(Find(side + "Arm", "abduction", spec)->rest / kDegree, kRaised, 1e-6);
    EXPECT_NEAR(Find(side + "Arm", "flexion", spec)->rest, 0.0, 1e-9);
    EXPECT_NEAR(Find(side + "ForeArm", "flexion", spec)->rest / kDegree, kBent, 1e-6);
    EXPECT_NEAR(Find(side + "UpLeg", "flexion", spec)->rest, 0.0, 1e-9);
  }
}

TEST(BodyHinges, GoAsFarAsPeopleDoWithoutAClip) {
  const FigureSpec spec = ImportWell(Person({})).project.figure.spec;
  for (const std::string side : {"Left", "Right"}) {
    const HingeSpec* knee = Find(side + "Leg", "flexion", spec);
    EXPECT_NEAR(knee->lower, 0.0, 1e-12) << "it does not bend backward";
    EXPECT_NEAR(knee->upper / kDegree, 130.0, 1e-9);
    EXPECT_TRUE(knee->strength);
    const HingeSpec* sideways = Find(side + "Leg", "abduction", spec);
    EXPECT_EQ(sideways->lower, sideways->upper);
  }
}

TEST(BodyHinges, AreTheSameForBonesWithOtherAxes) {
  const FigureSpec known = ImportWell(WithRaisedArms()).project.figure.spec;
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    Character other = WithRaisedArms();
    std::vector<Pose> X_W = WorldOf(other);
    for (size_t b = 1; b < X_W.size(); ++b) {
      const Mat3 turned = random.Rotation();
      Bone& bone = other.bones[b];
      if (bone.end_site) *bone.end_site = turned.transpose() * *bone.end_site;
      X_W[b].R = X_W[b].R * turned;
    }
    Lay(X_W, &other);
    const FigureSpec spec = ImportWell(other).project.figure.spec;
    ASSERT_EQ(spec.joints.size(), known.joints.size());
    for (size_t j = 0; j < spec.joints.size(); ++j) {
      if (!known.joints[j].body || known.joints[j].body->role == BodyRole::kNone) continue;
      for (size_t h = 0; h < 3; ++h) {
        const HingeSpec &is = spec.joints[j].hinges[h], &was = known.joints[j].hinges[h];
        EXPECT_EQ(is.name, was.name) << spec.joints[j].name;
        EXPECT_NEAR(is.rest, was.rest, 1e-9) << spec.joints[j].name << " " << is.name;
        EXPECT_NEAR(is.lower, was.lower, 1e-9) << spec.joints[j].name << " " << is.name;
      }
    }
  }
}

}  // namespace
}  // namespace hazumi::test
