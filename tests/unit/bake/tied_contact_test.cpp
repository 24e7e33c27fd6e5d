// Contacts with constraints: bodies that a constraint ties do not collide, and a constraint is
// compliant where contacts block it. Two starts with contact: deep inside a box, and just touching.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/bake/walk/own_pairs.h"
#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

void AddBox(Animation* animation, const Vec3& center, const Vec3& half) {
  SceneObject box;
  box.name = "box";
  box.shape = Box{{Mat3::Identity(), center}, half};
  animation->scene.push_back(box);
}

// Rod along x that swings about y at the origin, above a box under its end.
constexpr double kTop = -0.2;  // height of the top of the box [m]
Animation RodAboveBox() {
  Animation animation = Exact(RodAbout(Vec3::UnitY()), kG);
  animation.solver.tolerance = 0.01 * kDegree;
  DynamicsRegion& region = AddRegion(&animation, "arm", 0, 30, {"pivot"}, 0.9);
  region.method = Method::kExact;
  region.touches_scene = true;
  AddBox(&animation, Vec3(kLength, 0.0, kTop - 0.3), Vec3(0.2, 0.2, 0.3));
  return animation;
}

Constraint& DrawTipTo(const Vec3& place, Animation* animation) {
  ConstraintEnd tip = OnJoint(*animation, "pivot");
  tip.offset = kLength * Vec3::UnitX();
  Constraint& constraint = AddPoint(animation, tip, InWorld(place), 0, 30);
  constraint.arrive_frames = 10;
  return constraint;
}

double DepthOf(const Animation& animation, const Motion& motion) {
  double depth = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    depth = std::max(depth, -ClearanceOf(animation, frame));
  }
  return depth;
}

// Target of the tip half a radian below level, 0.18 m inside the box.
Vec3 InsideTheBox() { return kLength * Vec3(std::cos(0.5), 0.0, -std::sin(0.5)); }

TEST(TiedContact, TipDrawnToTheObjectItGrips_PassesThrough) {
  Animation animation = RodAboveBox();
  DrawTipTo(InsideTheBox(), &animation).b.object = 0;
  const Motion motion = BakeOrFail(animation);
  EXPECT_GE(DepthOf(animation, motion), 0.1);
  EXPECT_TRUE(motion.frames[15].contacts.pushes.empty());
  EXPECT_LE(GapAt(animation, animation.constraints[0], motion.frames[30]), 0.005);
}

TEST(TiedContact, TipThatCollides_StaysOutAndTheConstraintWarns) {
  Animation animation = RodAboveBox();
  Constraint& constraint = DrawTipTo(InsideTheBox(), &animation);
  constraint.b.object = 0;
  constraint.collides = true;
  const Motion motion = BakeOrFail(animation);
  EXPECT_LE(DepthOf(animation, motion), 5e-4);
  const auto names_it = [](const Warning& warning) {
    return warning.message.find("\"held\" has not arrived") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(motion.warnings.begin(), motion.warnings.end(), names_it));
}

// Rod that begins with the end of its axis 2 cm below the top of the box, tied to the box by a
// constraint.
Animation RodTiedInsideTheBox() {
  const double angle = std::asin((0.02 - kTop) / kLength);
  const Vec3 place = kLength * Vec3(std::cos(angle), 0.0, -std::sin(angle));
  Animation animation = RodAboveBox();
  KeysOf(&animation, "pivot") = {{0, angle, 0.0}};
  ConstraintEnd tip = OnJoint(animation, "pivot");
  tip.offset = kLength * Vec3::UnitX();
  AddPoint(&animation, tip, InWorld(place), 0, 30).b.object = 0;
  return animation;
}

bool WarnsOfInside(const Motion& motion) {
  return std::any_of(motion.warnings.begin(), motion.warnings.end(), [](const Warning& warning) {
    return warning.message.find("inside \"box\"") != std::string::npos;
  });
}

TEST(TiedContact, TipTiedInsideAnObject_StaysWithoutAWarning) {
  const Motion motion = BakeOrFail(RodTiedInsideTheBox());
  EXPECT_FALSE(WarnsOfInside(motion));
  EXPECT_TRUE(motion.frames[15].contacts.pushes.empty());
  Animation untied = RodTiedInsideTheBox();
  untied.constraints.clear();
  EXPECT_TRUE(WarnsOfInside(BakeOrFail(untied)));
}

TEST(TiedContact, BrokenConstraint_LetsItsEndsCollideAgain) {
  Animation animation = RodTiedInsideTheBox();
  animation.constraints[0].break_impulse = 0.2;
  AddForce(&animation, 10, 11,
           PushForce{{GroupOf(animation, "pivot"), Vec3(kLength, 0.0, 0.0)}, 0.5 * Vec3::UnitZ()});
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(motion.frames[9].contacts.pushes.empty());
  const auto is_break = [](const MotionEvent& event) { return event.kind == EventKind::kBreak; };
  ASSERT_TRUE(std::any_of(motion.events.begin(), motion.events.end(), is_break));
  // The box lets the rod out slowly, at 0.1 m/s at most.
  EXPECT_FALSE(motion.frames[20].contacts.pushes.empty());
  EXPECT_GE(ClearanceOf(animation, motion.frames[30]),
            ClearanceOf(animation, motion.frames[10]) + 0.03);
}

TEST(TiedContact, TipDrawnIntoAnUntiedObject_StaysOut) {
  Animation animation = RodAboveBox();
  DrawTipTo(InsideTheBox(), &animation);
  EXPECT_LE(DepthOf(animation, BakeOrFail(animation)), 5e-4);
}

TEST(DeepStart, CapsuleDeepInsideABox_ComesOutSlowly) {
  Animation animation = Loose(FreeCapsule(0.1, 0.05), 60);
  AddBox(&animation, Vec3(0.0, 0.0, -1.0), Vec3(3.0, 3.0, 1.0));
  SetRootAt(&animation, Vec3(0.0, 0.0, -0.25));
  const Motion motion = BakeOrFail(animation);
  double fastest = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    fastest = std::max(fastest, frame.after.root_v.norm());
  }
  EXPECT_GE(motion.frames.back().com.z(), -0.15);
  EXPECT_LE(fastest, 0.12);
}

TEST(SelfContact, LinksThatJustTouchAtRestStayOutOfEachOther) {
  FigureSpec spec;
  spec.name = "cradle";
  spec.root_name = "beam";
  for (int i = 0; i < 2; ++i) {
    JointSpec joint;
    joint.name = i == 0 ? "a" : "b";
    joint.parent = "beam";
    joint.offset = Vec3(kThickness * i, 0.0, 0.0);
    joint.hinges = {{"", Vec3::UnitY(), -1e3, 1e3, 0.0}};
    joint.links = {Rod(joint.name.c_str(), Vec3::Zero(), -kLength * Vec3::UnitZ())};
    spec.joints.push_back(joint);
  }
  spec.root_links = {Rod("beam", 5.0 * Vec3::UnitZ(), 5.1 * Vec3::UnitZ())};
  const Figure figure = BuildFigure(spec).value();
  const auto has_both = [&](bool with_touching) {
    const std::vector<LinkPair> pairs = PairsApart(figure, with_touching);
    return std::any_of(pairs.begin(), pairs.end(), [&](const LinkPair& pair) {
      return figure.links()[pair.a].name == "a" && figure.links()[pair.b].name == "b";
    });
  };
  EXPECT_TRUE(has_both(/*with_touching=*/true));
  EXPECT_FALSE(has_both(/*with_touching=*/false));
}

}  // namespace
}  // namespace hazumi::test
