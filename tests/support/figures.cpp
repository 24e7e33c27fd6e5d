#include "tests/support/figures.h"

#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "engine/figure/figure_builder.h"

namespace hazumi::test {

namespace {

// A body part: concentric hinges and a solid cylinder beyond them.
struct Part {
  std::string name, parent;
  Vec3 offset;
  std::string axes;  // e.g. "yxz", from the parent outwards
  double mass, radius, length;
  char along;  // axis of the cylinder
  Vec3 centre;
};

const std::vector<Part> kTrunk = {
    {"spine", "pelvis", {0, 0, 0.08}, "yxz", 9.2, 0.12, 0.17, 'z', {0, 0, 0.085}},
    {"chest", "spine", {0, 0, 0.17}, "yxz", 15.0, 0.14, 0.25, 'z', {0, 0, 0.125}},
    {"neck", "chest", {0, 0, 0.25}, "yxz", 5.2, 0.08, 0.25, 'z', {0, 0, 0.125}}};

std::vector<Part> ArmParts(const std::string& side, const std::string& parent, const Vec3& at) {
  const std::string shoulder = side + "_shoulder", elbow = side + "_elbow";
  return {{shoulder, parent, at, "yxz", 2.0, 0.045, 0.29, 'z', {0, 0, -0.145}},
          {elbow, shoulder, {0, 0, -0.29}, "yz", 1.2, 0.038, 0.25, 'z', {0, 0, -0.125}},
          {side + "_wrist", elbow, {0, 0, -0.25}, "xy", 0.4, 0.035, 0.18, 'z', {0, 0, -0.09}}};
}

std::vector<Part> LegParts(const std::string& side, const Vec3& at) {
  const std::string hip = side + "_hip", knee = side + "_knee", ankle = side + "_ankle";
  return {{hip, "pelvis", at, "yxz", 7.5, 0.075, 0.42, 'z', {0, 0, -0.21}},
          {knee, hip, {0, 0, -0.42}, "y", 3.2, 0.055, 0.40, 'z', {0, 0, -0.20}},
          {ankle, knee, {0, 0, -0.40}, "yx", 0.8, 0.04, 0.20, 'x', {0.05, 0, -0.04}},
          {side + "_toe", ankle, {0.15, 0, -0.06}, "y", 0.2, 0.03, 0.07, 'x', {0.035, 0, 0}}};
}

Vec3 Axis(char letter) { return Vec3::Unit(letter - 'x'); }

LinkSpec Cylinder(const std::string& name, double mass, double radius, const Vec3& centre,
                  const Vec3& along) {
  LinkSpec link;
  link.name = name;
  link.from = centre - 0.5 * along;
  link.to = centre + 0.5 * along;
  link.radius = radius;
  link.mass = mass;
  return link;
}

void AddParts(const std::vector<Part>& parts, FigureSpec* spec) {
  for (const Part& part : parts) {
    JointSpec joint;
    joint.name = part.name;
    joint.parent = part.parent;
    joint.offset = part.offset;
    for (const char letter : part.axes) {
      joint.hinges.push_back(
          {std::string(1, letter), Axis(letter), -std::numbers::pi, std::numbers::pi, 0.0});
    }
    joint.links.push_back(
        Cylinder(part.name, part.mass, part.radius, part.centre, part.length * Axis(part.along)));
    spec->joints.push_back(joint);
  }
}

}  // namespace

Figure Build(const FigureSpec& spec) {
  Result<Figure> figure = BuildFigure(spec);
  if (figure.ok()) return std::move(figure).value();
  std::fprintf(stderr, "test figure: %s\n", figure.error().ToString().c_str());
  std::abort();
}

Figure Human37() {
  FigureSpec spec;
  spec.name = "human37";
  spec.root_name = "pelvis";
  spec.root_links = {Cylinder("pelvis", 10.0, 0.14, Vec3::Zero(), {0, 0, 0.16})};
  AddParts(kTrunk, &spec);
  AddParts(ArmParts("l", "chest", {0, 0.18, 0.20}), &spec);
  AddParts(ArmParts("r", "chest", {0, -0.18, 0.20}), &spec);
  AddParts(LegParts("l", {0, 0.09, -0.05}), &spec);
  AddParts(LegParts("r", {0, -0.09, -0.05}), &spec);
  return Build(spec);
}

FigureSpec Arm7Spec() {
  FigureSpec spec;
  spec.name = "arm7";
  spec.root_name = "base";
  AddParts(ArmParts("r", "base", Vec3::Zero()), &spec);
  return spec;
}

Figure Arm7() { return Build(Arm7Spec()); }

Figure Pendulum(double mass, double radius, double length) {
  FigureSpec spec;
  spec.name = "pendulum";
  spec.root_name = "base";
  AddParts({{"rod", "base", Vec3::Zero(), "y", mass, radius, length, 'z', {0, 0, -0.5 * length}}},
           &spec);
  return Build(spec);
}

}  // namespace hazumi::test
