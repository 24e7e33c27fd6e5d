#include "engine/figure/figure_builder.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

LinkSpec Rod(double mass) {
  LinkSpec link;
  link.name = "rod";
  link.to = Vec3(0, 0, -0.3);
  link.radius = 0.05;
  link.mass = mass;
  return link;
}

JointSpec OneHinge(const std::string& name, const std::string& parent) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.hinges = {{"", Vec3::UnitY(), -1.0, 1.0, 0.25}};
  joint.links = {Rod(1.0)};
  return joint;
}

// root - a - b, and root - c.
FigureSpec Small() {
  FigureSpec spec;
  spec.name = "small";
  spec.root_name = "root";
  spec.root_links = {Rod(2.0)};
  spec.joints = {OneHinge("a", "root"), OneHinge("b", "a"), OneHinge("c", "root")};
  return spec;
}

TEST(FigureBuilder, BuildsAChainOfTenThousandAndFindsItsNames) {
  FigureSpec spec = Small();
  spec.joints = {OneHinge("j0", "root")};
  for (int i = 1; i < 10000; ++i) {
    spec.joints.push_back(OneHinge("j" + std::to_string(i), "j" + std::to_string(i - 1)));
  }
  const Figure chain = Build(spec);
  ASSERT_EQ(chain.num_joints(), 10000);
  for (int i = 0; i < 10000; ++i) {
    EXPECT_EQ(chain.FindJoint("j" + std::to_string(i)), JointIndex(i));
    EXPECT_EQ(chain.joint(JointIndex(i)).subtree_end, JointIndex(10000));
  }
  EXPECT_EQ(chain.FindJoint("j10000"), std::nullopt);
  EXPECT_EQ(chain.FindGroup("j9999"), GroupIndex(9999));
}

struct WrongSpec {
  const char* place;
  const char* message;
  std::function<void(FigureSpec*)> spoil;
};

const std::vector<WrongSpec> kWrongSpecs = {
    {"joints[1].links[0]", "needs exactly one of mass and density",
     [](FigureSpec* s) { s->joints[1].links[0].mass.reset(); }},
    {"joints[1].links[0]", "needs exactly one of mass and density",
     [](FigureSpec* s) { s->joints[1].links[0].density = 1000.0; }},
    {"root.links[0]", "needs exactly one of mass and density",
     [](FigureSpec* s) { s->root_links[0].mass.reset(); }},
    {"joints[2].links[0].inertia_kg_m2", "no body has these moments",
     [](FigureSpec* s) { s->joints[2].links[0].inertia = Vec3(1, 1, 3).asDiagonal(); }},
    {"root.links[0].inertia_kg_m2", "no body has these moments",
     [](FigureSpec* s) { s->root_links[0].inertia = Vec3(1, 1, -1).asDiagonal(); }},
    {"joints[0].hinges[0].axis", "must not be zero",
     [](FigureSpec* s) { s->joints[0].hinges[0].axis.setZero(); }},
    {"joints[0].hinges[0].limits_deg", "the lower limit is above the upper one",
     [](FigureSpec* s) { s->joints[0].hinges[0].lower = 2.0; }},
    {"joints[1].hinges", "one to three hinges", [](FigureSpec* s) { s->joints[1].hinges.clear(); }},
    {"joints[1].hinges", "one to three hinges",
     [](FigureSpec* s) {
       s->joints[1].hinges.assign(4, {"x", Vec3::UnitX(), -1.0, 1.0});
     }},
    {"joints[2]", "\"a\" is already used by joints[0]",
     [](FigureSpec* s) { s->joints[2].name = "a"; }},
    {"joints[2]", "\"root\" is already used by root",
     [](FigureSpec* s) { s->joints[2].name = "root"; }},
    {"joints[1]", "\"b_x\" is already used by joints[1]",
     [](FigureSpec* s) {
       s->joints[1].hinges.assign(2, {"x", Vec3::UnitX(), -1.0, 1.0});
     }},
    {"joints[2]", "\"b_x\" is already used by joints[1]",
     [](FigureSpec* s) {
       s->joints[1].hinges[0].name = "x";
       s->joints[2].name = "b_x";
     }},
    {"joints[1].parent", "no joint \"nobody\"",
     [](FigureSpec* s) { s->joints[1].parent = "nobody"; }},
    {"joints[0].parent", "\"a\" is its own ancestor",
     [](FigureSpec* s) { s->joints[0].parent = "b"; }},
    {"joints[2].parent", "\"c\" is its own ancestor",
     [](FigureSpec* s) { s->joints[2].parent = "c"; }},
    {"", "the figure has no mass",
     [](FigureSpec* s) {
       s->root_links.clear();
       for (JointSpec& joint : s->joints) joint.links.clear();
     }},
};

TEST(FigureBuilder, SaysWhatIsWrongAndWhere) {
  for (const WrongSpec& wrong : kWrongSpecs) {
    FigureSpec spec = Small();
    wrong.spoil(&spec);
    const Result<Figure> figure = BuildFigure(spec);
    ASSERT_FALSE(figure.ok()) << wrong.place << ": " << wrong.message;
    EXPECT_EQ(figure.error().code, ErrorCode::kSchema);
    EXPECT_EQ(figure.error().place, wrong.place);
    EXPECT_NE(figure.error().message.find(wrong.message), std::string::npos)
        << figure.error().message;
  }
}

TEST(FigureBuilder, AcceptsTheSpecificationThatTheWrongOnesWereMadeFrom) {
  EXPECT_TRUE(BuildFigure(Small()).ok());
}

// A moment of zero comes out of the eigenvalues as plus or minus 1e-17.
TEST(FigureBuilder, AcceptsThinRodsWhateverTheirDirection) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    FigureSpec spec = Small();
    const Mat3 R = random.Rotation();
    spec.joints[0].links[0].inertia = R * Vec3(0.0, 0.1, 0.1).asDiagonal() * R.transpose();
    EXPECT_TRUE(BuildFigure(spec).ok()) << "rotation " << i;
  }
}

TEST(FigureBuilder, NumbersDepthFirstWithContiguousSubtrees) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const Figure figure = Build(RandomTreeSpec(&random));
    for (int j = 0; j < figure.num_joints(); ++j) {
      EXPECT_LT(figure.joints()[j].parent.value(), j) << "seed " << seed;
      for (int k = 0; k < figure.num_joints(); ++k) {
        bool below = false;  // by walking up, not by ranges
        for (JointIndex up(k); up.is_valid(); up = figure.joint(up).parent)
          below |= up.value() == j;
        EXPECT_EQ(figure.IsBeyond(JointIndex(k), JointIndex(j)), below)
            << "seed " << seed << ": " << k << " beyond " << j;
      }
    }
  }
}

TEST(FigureBuilder, KeepsChildrenInTheOrderGivenThoughParentsComeLater) {
  FigureSpec spec = Small();
  std::swap(spec.joints[0], spec.joints[1]);  // b before its parent a
  const Figure figure = Build(spec);
  ASSERT_EQ(figure.num_joints(), 3);
  EXPECT_EQ(figure.joints()[0].name, "a");
  EXPECT_EQ(figure.joints()[1].name, "b");
  EXPECT_EQ(figure.joints()[2].name, "c");
}

TEST(FigureBuilder, PutsTheLinksOnTheLastHingeOfAGroupAndNothingOnTheOthers) {
  const Figure human = Human37();
  EXPECT_EQ(human.num_joints(), 37);
  EXPECT_NEAR(human.total_mass(), 70.0, 1e-12);
  for (const JointGroup& group : human.groups()) {
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      EXPECT_EQ(human.joints()[j].massless, j != group.last().value());
      EXPECT_EQ(human.body(JointIndex(j)).is_massless(), j != group.last().value());
    }
  }
}

TEST(FigureBuilder, TakesMassFromDensityAndInertiaFromTheCylinder) {
  FigureSpec spec = Small();
  LinkSpec& link = spec.joints[0].links[0];
  link.mass.reset();
  link.density = 1000.0;
  const Figure figure = Build(spec);
  const RigidInertia& body = figure.body(JointIndex(0));
  const double mass = 1000.0 * std::numbers::pi * 0.05 * 0.05 * 0.3;
  const double across = mass * (3 * 0.05 * 0.05 + 0.3 * 0.3) / 12.0;
  const Mat3 expected = Vec3(across, across, 0.5 * mass * 0.05 * 0.05).asDiagonal();
  EXPECT_NEAR(body.mass, mass, 1e-14);
  EXPECT_TRUE(body.com.isApprox(Vec3(0, 0, -0.15), 1e-15));
  EXPECT_TRUE(body.I_com.isApprox(expected, 1e-14));
}

TEST(FigureBuilder, SumsTheLinksThatShareAJoint) {
  FigureSpec spec = Small();
  LinkSpec other = Rod(3.0);
  other.to = Vec3(0.2, 0.1, 0);
  spec.joints[0].links.push_back(other);
  const RigidInertia body = Build(spec).body(JointIndex(0));
  const RigidInertia expected = Combine(SolidCylinder({0, 0, 0}, {0, 0, -0.3}, 0.05, 1.0),
                                        SolidCylinder({0, 0, 0}, {0.2, 0.1, 0}, 0.05, 3.0));
  EXPECT_EQ(body.mass, 4.0);
  EXPECT_TRUE(body.com.isApprox(expected.com, 1e-15));
  EXPECT_TRUE(body.I_com.isApprox(expected.I_com, 1e-15));
}

FigureSpec Chain(int joints) {
  FigureSpec spec;
  spec.root_name = "root";
  for (int i = 0; i < joints; ++i) {
    spec.joints.push_back(
        OneHinge("j" + std::to_string(i), i ? "j" + std::to_string(i - 1) : "root"));
  }
  return spec;
}

TEST(FigureBuilder, BuildsADeepChain) {
  const Figure chain = Build(Chain(2000));
  ASSERT_EQ(chain.num_joints(), 2000);
  EXPECT_EQ(chain.joints()[0].subtree_end.value(), 2000);
  EXPECT_EQ(chain.joints()[1999].parent.value(), 1998);
}

TEST(FigureBuilder, FindsALongLoop) {
  FigureSpec spec = Chain(2000);
  spec.joints[0].parent = "j1999";
  const Result<Figure> figure = BuildFigure(spec);
  ASSERT_FALSE(figure.ok());
  EXPECT_NE(figure.error().message.find("the parents form a loop"), std::string::npos);
}

TEST(Figure, FindsJointsAndGroupsByName) {
  const Figure arm = Arm7();
  EXPECT_EQ(arm.FindJoint("r_elbow_z"), JointIndex(4));
  EXPECT_EQ(arm.FindGroup("r_elbow")->value(), 1);
  EXPECT_FALSE(arm.FindJoint("r_elbow").has_value());
  EXPECT_FALSE(arm.FindGroup("r_elbow_z").has_value());
}

TEST(Figure, RestsAtItsRestAngles) {
  EXPECT_EQ(Build(Small()).RestAngles(), VecX::Constant(3, 0.25));
}

TEST(Figure, WithLoadAddsTheLoadToOneBodyAndToTheWhole) {
  const Figure arm = Arm7();
  const RigidInertia ball = SolidSphere({0, 0, -0.2}, 0.05, 0.3);
  for (const int j : {5, 6}) {  // a massless body and one with mass
    const Figure loaded = arm.WithLoad(JointIndex(j), ball);
    EXPECT_NEAR(loaded.total_mass(), arm.total_mass() + 0.3, 1e-15);
    EXPECT_FALSE(loaded.joints()[j].massless);
    const RigidInertia expected = Combine(arm.body(JointIndex(j)), ball);
    EXPECT_EQ(loaded.body(JointIndex(j)).I_com, expected.I_com);
    EXPECT_EQ(loaded.body(JointIndex(4)).mass, arm.body(JointIndex(4)).mass);
  }
  EXPECT_EQ(arm.body(JointIndex(6)).mass, 0.4) << "the figure itself must not change";
}

}  // namespace
}  // namespace hazumi::test
