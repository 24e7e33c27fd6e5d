#include "tests/support/stick_figures.h"

#include <utility>

#include "engine/figure/figure_builder.h"

namespace hazumi::test {
namespace {

constexpr double kLimit = 3.0;  // [rad]: far from anything that tests do

LinkSpec Link(const std::string& name, const Vec3& to, double radius, double mass) {
  LinkSpec link;
  link.name = name;
  link.to = to;
  link.radius = radius;
  link.mass = mass;
  return link;
}

LinkSpec Ball(const std::string& name, double radius, double mass) {
  LinkSpec link = Link(name, Vec3::Zero(), radius, mass);
  link.inertia = 0.4 * mass * radius * radius * Mat3::Identity();
  return link;
}

HingeSpec Hinge(char axis) {
  HingeSpec hinge;
  hinge.name = std::string(1, axis);
  hinge.axis = axis == 'x' ? Vec3::UnitX() : axis == 'y' ? Vec3::UnitY() : Vec3::UnitZ();
  hinge.lower = -kLimit;
  hinge.upper = kLimit;
  return hinge;
}

JointSpec JointOf(const std::string& name, const std::string& parent, const Vec3& offset,
                  const std::string& axes, LinkSpec link) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = offset;
  for (const char axis : axes) joint.hinges.push_back(Hinge(axis));
  if (axes.size() == 1) joint.hinges[0].name.clear();
  joint.links.push_back(std::move(link));
  return joint;
}

FigureSpec Root(LinkSpec link) {
  FigureSpec spec;
  spec.name = "stick";
  spec.root_name = "root";
  spec.root_links.push_back(std::move(link));
  return spec;
}

Vec3 Down(double length) { return {0.0, 0.0, -length}; }

void AddLeg(const std::string& side, double y, FigureSpec* spec) {
  const auto name = [&](const char* joint) { return side + joint; };
  spec->joints.push_back(
      JointOf(name("hip"), "root", {0, y, -0.05}, "yxz", Link(name("thigh"), Down(0.4), 0.06, 9)));
  spec->joints.push_back(
      JointOf(name("knee"), name("hip"), Down(0.4), "y", Link(name("shank"), Down(0.4), 0.04, 3)));
  spec->joints.push_back(JointOf(name("ankle"), name("knee"), Down(0.4), "yx",
                                 Link(name("foot"), {0.15, 0, -0.07}, 0.03, 0.8)));
  spec->joints.push_back(JointOf(name("toe"), name("ankle"), {0.15, 0, -0.07}, "y",
                                 Link(name("toes"), {0.05, 0, 0}, 0.03, 0.2)));
}

void AddArm(const std::string& side, const std::string& parent, const Vec3& offset,
            FigureSpec* spec) {
  const auto name = [&](const char* joint) { return side + joint; };
  spec->joints.push_back(JointOf(name("shoulder"), parent, offset, "xyz",
                                 Link(name("upper_arm"), Down(0.3), 0.04, 1.9)));
  spec->joints.push_back(JointOf(name("elbow"), name("shoulder"), Down(0.3), "yz",
                                 Link(name("forearm"), Down(0.25), 0.03, 1.1)));
  spec->joints.push_back(JointOf(name("wrist"), name("elbow"), Down(0.25), "xy",
                                 Link(name("hand"), Down(0.1), 0.03, 0.4)));
}

Figure BuildSpec(const FigureSpec& spec) { return BuildFigure(spec).value(); }

}  // namespace

Figure Pogo() {
  FigureSpec spec = Root(Ball("body", 0.1, 4.0));
  spec.joints.push_back(JointOf("foot", "root", Down(0.5), "y", Ball("sole", 0.05, 1.0)));
  return BuildSpec(spec);
}

Figure TwoLinks() {
  FigureSpec spec = Root(Ball("body", 0.1, 3.0));
  spec.joints.push_back(JointOf("knee", "root", Down(0.4), "y", Link("shank", Down(0.4), 0.04, 2)));
  spec.joints.push_back(JointOf("foot", "knee", Down(0.4), "y", Ball("sole", 0.05, 1.0)));
  return BuildSpec(spec);
}

Figure Leg() {
  FigureSpec spec = Root(Ball("body", 0.1, 40.0));
  AddLeg("", 0.0, &spec);
  return BuildSpec(spec);
}

Figure Arm() {
  FigureSpec spec = Root(Ball("body", 0.1, 40.0));
  AddArm("", "root", {0, -0.2, 0.4}, &spec);
  spec.joints.push_back(JointOf("tip", "wrist", Down(0.1), "y", Ball("ball", 0.03, 0.1)));
  return BuildSpec(spec);
}

Figure Human() {
  FigureSpec spec = Root(Link("pelvis", {0, 0, 0.1}, 0.1, 10));
  spec.joints.push_back(
      JointOf("waist", "root", {0, 0, 0.12}, "yxz", Link("abdomen", {0, 0, 0.2}, 0.1, 10)));
  spec.joints.push_back(
      JointOf("chest", "waist", {0, 0, 0.2}, "yxz", Link("chest", {0, 0, 0.2}, 0.1, 15)));
  spec.joints.push_back(
      JointOf("neck", "chest", {0, 0, 0.25}, "yxz", Link("head", {0, 0, 0.2}, 0.08, 4)));
  AddArm("r_", "chest", {0, -0.2, 0.2}, &spec);
  AddArm("l_", "chest", {0, 0.2, 0.2}, &spec);
  AddLeg("r_", -0.1, &spec);
  AddLeg("l_", 0.1, &spec);
  return BuildSpec(spec);
}

}  // namespace hazumi::test
