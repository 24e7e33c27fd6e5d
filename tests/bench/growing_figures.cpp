#include "tests/bench/growing_figures.h"

#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

constexpr double kRod = 0.1;  // [m]

Figure Rods(const std::string& name, int joints, int (*parent_of)(int)) {
  FigureSpec spec;
  spec.name = name;
  spec.root_name = "base";
  for (int i = 0; i < joints; ++i) {
    JointSpec joint;
    joint.name = "j" + std::to_string(i);
    const int parent = parent_of(i);
    joint.parent = parent < 0 ? spec.root_name : "j" + std::to_string(parent);
    if (parent >= 0) joint.offset = Vec3(0.0, 0.0, -kRod);
    joint.hinges = {{"", Vec3::Unit(i % 2), -3.0, 3.0, 0.0}};
    LinkSpec rod;
    rod.name = joint.name;
    rod.to = Vec3(0.0, 0.0, -kRod);
    rod.radius = 0.2 * kRod;
    rod.mass = 1.0;
    joint.links = {rod};
    spec.joints.push_back(joint);
  }
  return test::Build(spec);
}

}  // namespace

Figure Chain(int joints) {
  return Rods("chain", joints, [](int i) { return i - 1; });
}

Figure BinaryTree(int joints) {
  return Rods("tree", joints, [](int i) { return i == 0 ? -1 : (i - 1) / 2; });
}

}  // namespace hazumi::bench
