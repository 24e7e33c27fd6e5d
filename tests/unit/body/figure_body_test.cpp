#include "engine/body/figure_body.h"

#include <gtest/gtest.h>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"

namespace hazumi::test {
namespace {

Figure Human() {
  Result<Figure> built = BuildFigure(HumanFigure());
  EXPECT_TRUE(built.ok());
  return std::move(built).value();
}

TEST(FigureBody, TheHumansHingesAreItsOwn) {
  const Figure human = Human();
  const FigureBody body(human);
  for (const Joint& joint : human.joints()) {
    const std::vector<HingeShare> shares = body.HingesFor(joint.name);
    ASSERT_EQ(shares.size(), 1u) << joint.name;
    EXPECT_EQ(human.joint(shares[0].hinge).name, joint.name);
    EXPECT_EQ(shares[0].share, 1.0) << joint.name;
  }
  EXPECT_TRUE(body.HingesFor("tail_wag").empty());
  EXPECT_NEAR(StandingHeight(human), 0.9024, 0.01);
}

// A spine of `count` joints between hips and a head.
Figure Spine(int count) {
  FigureSpec spec;
  spec.root_name = "hips";
  LinkSpec link;
  link.name = "link";
  link.to = Vec3(0.0, 0.0, 0.1);
  link.radius = 0.05;
  link.mass = 1.0;
  spec.root_links = {link};
  for (int i = 0; i < count; ++i) {
    JointSpec joint;
    joint.name = "s" + std::to_string(i);
    joint.parent = i == 0 ? "hips" : "s" + std::to_string(i - 1);
    joint.body = BodyPlace{BodyRole::kSpine, BodySide::kMiddle};
    joint.hinges = {{"flexion", Vec3::UnitY(), -1.0, 1.0, 0.0, {}},
                    {"bend", Vec3::UnitX(), 0.0, 0.0, 0.0, {}}};
    joint.links = {link};
    spec.joints.push_back(joint);
  }
  Result<Figure> built = BuildFigure(spec);
  EXPECT_TRUE(built.ok());
  return std::move(built).value();
}

// Whatever the number of joints, the angles add up, and come back as the human's.
TEST(FigureBody, ASpineSharesWhatWaistAndChestDo) {
  for (const int count : {1, 2, 3, 4, 5}) {
    const Figure figure = Spine(count);
    const FigureBody body(figure);
    VecX q = VecX::Zero(figure.num_joints());
    for (const auto& [name, angle] : {std::pair{"waist_flexion", 0.3}, {"chest_flexion", 0.1}}) {
      for (const HingeShare& share : body.HingesFor(name))
        q[share.hinge.value()] += share.share * angle;
    }
    EXPECT_NEAR(q.sum(), 0.4, 1e-12) << count;
    double sum = 0.0;
    for (const auto& [name, angle] : body.HumanAngles(q)) sum += angle;
    EXPECT_NEAR(sum, 0.4, 1e-12) << count;
    EXPECT_TRUE(body.HingesFor("waist_bend").empty()) << "fixed";
  }
}

TEST(FigureBody, RolesThatAreStatedCount) {
  FigureSpec spec = HumanFigure();
  for (JointSpec& joint : spec.joints) {
    if (joint.name == "r_knee") joint.body = BodyPlace{BodyRole::kTail, BodySide::kMiddle};
  }
  Result<Figure> built = BuildFigure(spec);
  ASSERT_TRUE(built.ok());
  const FigureBody body(built.value());
  EXPECT_FALSE(body.Find(BodyRole::kShin, BodySide::kRight));
  EXPECT_EQ(body.All(BodyRole::kTail, BodySide::kMiddle).size(), 2u) << "and its twin";
}

}  // namespace
}  // namespace hazumi::test
