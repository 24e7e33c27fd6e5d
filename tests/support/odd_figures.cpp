#include "tests/support/odd_figures.h"

#include <numbers>

#include "tests/support/figures.h"

namespace hazumi::test {

namespace {

constexpr double kFar = 1e6;  // no limit [rad]

void SetLimits(const VecX& lower, const VecX& upper, FigureSpec* spec) {
  int j = 0;
  for (JointSpec& joint : spec->joints) {
    for (HingeSpec& hinge : joint.hinges) {
      hinge.lower = lower[j];
      hinge.upper = upper[j];
      ++j;
    }
  }
}

HingeSpec HingeAboutY(double lower, double upper) { return {"", Vec3::UnitY(), lower, upper, 0.0}; }

LinkSpec Rod(const std::string& name, double mass, const Vec3& to, double radius) {
  LinkSpec link;
  link.name = name;
  link.to = to;
  link.radius = radius;
  link.mass = mass;
  return link;
}

JointSpec JointOn(const std::string& name, const std::string& parent, const Vec3& offset,
                  std::vector<HingeSpec> hinges, LinkSpec link) {
  return {name, parent, offset, Mat3::Identity(), std::move(hinges), {std::move(link)}};
}

FigureSpec OnBase(const char* name) {
  FigureSpec spec;
  spec.name = name;
  spec.root_name = "base";
  return spec;
}

FigureSpec FreeArm7Spec() {
  FigureSpec spec = Arm7Spec();
  SetLimits(VecX::Constant(7, -kFar), VecX::Constant(7, kFar), &spec);
  return spec;
}

}  // namespace

LinkSpec Lump(const std::string& name, double mass, const Vec3& com, double moment) {
  LinkSpec link;
  link.name = name;
  link.from = link.to = com;
  link.radius = 0.01;
  link.mass = mass;
  link.com = com;
  link.inertia = moment * Mat3::Identity();
  return link;
}

VecX BentArm() {
  VecX q(7);
  q << -1.9, -0.55, 0.4, -1.2, 0.3, 0.2, 0.4;
  return q;
}

Figure Arm7Within(const VecX& lower, const VecX& upper, double hand_scale) {
  FigureSpec spec = Arm7Spec();
  SetLimits(lower, upper, &spec);
  *spec.joints[2].links[0].mass *= hand_scale;  // the cylinder's inertia follows
  return Build(spec);
}

Figure FreeArm7(double hand_scale) {
  return Arm7Within(VecX::Constant(7, -kFar), VecX::Constant(7, kFar), hand_scale);
}

Figure FreeArm7WithShoulderXyz() {
  FigureSpec spec = FreeArm7Spec();
  std::swap(spec.joints[0].hinges[0], spec.joints[0].hinges[1]);
  return Build(spec);
}

namespace {

FigureSpec ChainSpec(int links) {
  FigureSpec spec = OnBase("chain");
  const Vec3 down(0.0, 0.0, -1.0 / links);
  for (int i = 0; i < links; ++i) {
    spec.joints.push_back(JointOn("j" + std::to_string(i),
                                  i == 0 ? "base" : "j" + std::to_string(i - 1),
                                  i == 0 ? Vec3(Vec3::Zero()) : down, {HingeAboutY(-kFar, kFar)},
                                  Rod("l" + std::to_string(i), 1.0 / links, down, 0.002)));
  }
  return spec;
}

}  // namespace

Figure Chain(int links) { return Build(ChainSpec(links)); }

Figure RodWithin(double lower, double upper) {
  FigureSpec spec = ChainSpec(1);
  SetLimits(VecX::Constant(1, lower), VecX::Constant(1, upper), &spec);
  return Build(spec);
}

Figure RodsOnAStop() {
  FigureSpec spec = ChainSpec(2);
  SetLimits(VecX::Constant(2, -kFar), Eigen::Vector2d(-0.5 * std::numbers::pi, kFar), &spec);
  return Build(spec);
}

Figure ThinRod(double length) {
  FigureSpec spec = OnBase("thin rod");
  LinkSpec rod = Rod("rod", 1.0, Vec3(0.0, 0.0, -length), 0.01);
  const double across = length * length / 12.0;
  rod.inertia = Vec3(across, across, 0.0).asDiagonal();
  spec.joints.push_back(JointOn("ball", "base", Vec3::Zero(),
                                {{"y", Vec3::UnitY(), -kFar, kFar, 0.0},
                                 {"x", Vec3::UnitX(), -kFar, kFar, 0.0},
                                 {"z", Vec3::UnitZ(), -kFar, kFar, 0.0}},
                                rod));
  return Build(spec);
}

Figure RoundBall() {
  FigureSpec spec = OnBase("round");
  spec.joints.push_back(JointOn("ball", "base", Vec3::Zero(),
                                {{"y", Vec3::UnitY(), -kFar, kFar, 0.0},
                                 {"x", Vec3::UnitX(), -kFar, kFar, 0.0},
                                 {"z", Vec3::UnitZ(), -kFar, kFar, 0.0}},
                                Lump("body", 1.0, Vec3::Zero(), 0.05)));
  return Build(spec);
}

Figure StrongRod(double torque) {
  FigureSpec spec = OnBase("strong");
  HingeSpec hinge = HingeAboutY(-kFar, kFar);
  hinge.rest = -0.5 * std::numbers::pi;
  hinge.strength.emplace();
  hinge.strength->positive.torque = hinge.strength->negative.torque = torque;
  spec.joints.push_back(
      JointOn("hinge", "base", Vec3::Zero(), {hinge}, Rod("rod", 1.0, Vec3::UnitX(), 0.01)));
  return Build(spec);
}

// With moments G1, G2 of gravity about the hinges and inertias M11, M12, M22, M12 > 0: stopping the
// first changes the rate of the second by M12 / M22 times what it had, off its limit, and the other
// way round. Of a rate M12^2 / (M11 M22) = 0.967 is left after two such blows.
Figure LimitsThatKickEachOther() {
  FigureSpec spec = OnBase("kicks");
  const double arm = 0.03, beyond = 0.02;
  spec.joints.push_back(JointOn("first", "base", Vec3::Zero(), {HingeAboutY(-1.0, 0.0)},
                                Lump("lever", 0.1, Vec3(0.5 * arm, 0, 0), 1e-4)));
  spec.joints.push_back(JointOn("second", "first", Vec3(arm, 0, 0), {HingeAboutY(0.0, 1.0)},
                                Lump("weight", 1.0, Vec3(-beyond, 0, 0), 0.03)));
  return Build(spec);
}

Figure MirrorArms(double left, double right) {
  FigureSpec spec = OnBase("mirror arms");
  spec.joints.push_back(JointOn("bar", "base", Vec3::Zero(), {HingeAboutY(-kFar, kFar)},
                                Lump("beam", 2.0, Vec3::Zero(), 0.02)));
  const Vec3 down(0.0, 0.0, -0.3);
  spec.joints.push_back(JointOn("left", "bar", Vec3(-0.2, 0, 0), {HingeAboutY(-left, left)},
                                Rod("left", 1.0, down, 0.02)));
  spec.joints.push_back(JointOn("right", "bar", Vec3(0.2, 0, 0), {HingeAboutY(-right, right)},
                                Rod("right", 1.0, down, 0.02)));
  return Build(spec);
}

}  // namespace hazumi::test
