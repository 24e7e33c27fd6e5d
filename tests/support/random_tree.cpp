#include "tests/support/random_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hazumi::test {

namespace {

// A capsule whose stated mass, centre and inertia have nothing to do with its shape.
LinkSpec StatedLink(Random* random) {
  LinkSpec link;
  link.to = random->Vector3(0.3);
  link.radius = 0.05;
  link.mass = random->LogUniform(0.2, 10.0);
  link.com = random->Vector3(0.2);
  link.inertia = random->Inertia(*link.mass, 0.2);
  return link;
}

LinkSpec CylinderLink(Random* random) {
  LinkSpec link;
  link.from = random->Vector3(0.2);
  link.to = random->Vector3(0.2);
  link.radius = random->Uniform(0.02, 0.1);
  link.density = random->Uniform(500.0, 1500.0);
  return link;
}

std::vector<LinkSpec> RandomLinks(Random* random) {
  std::vector<LinkSpec> links = {StatedLink(random)};
  if (random->Chance(0.5)) links.push_back(CylinderLink(random));
  return links;
}

// Half of the parents are the last joint, so that long chains and wide trees both occur.
std::string RandomParent(const FigureSpec& spec, Random* random) {
  const int size = static_cast<int>(spec.joints.size());
  const int choice = random->Chance(0.5) ? size - 1 : random->Integer(-1, size - 1);
  return choice < 0 ? spec.root_name : spec.joints[choice].name;
}

JointSpec RandomJoint(const FigureSpec& spec, int hinges, Random* random) {
  JointSpec joint;
  joint.name = "j" + std::to_string(spec.joints.size());
  joint.parent = RandomParent(spec, random);
  joint.offset = random->Vector3(0.4);
  if (random->Chance(0.5)) joint.orientation = random->Rotation();
  const Mat3 axes = random->Chance(0.5) ? random->Rotation() : Mat3(Mat3::Identity());
  for (int h = 0; h < hinges; ++h) {
    joint.hinges.push_back({std::string(1, static_cast<char>('a' + h)), axes.col(h), -3.0, 3.0});
  }
  joint.links = RandomLinks(random);
  return joint;
}

}  // namespace

FigureSpec RandomTreeSpec(Random* random) {
  FigureSpec spec;
  spec.name = "random tree";
  spec.root_name = "root";
  spec.root_links = RandomLinks(random);
  for (int left = random->Integer(3, 40); left > 0;) {
    const int hinges = std::min(left, random->Integer(1, 3));
    spec.joints.push_back(RandomJoint(spec, hinges, random));
    left -= hinges;
  }
  return spec;
}

VecX RandomAngles(const Figure& figure, Random* random) {
  VecX q = random->Vector(figure.num_joints(), std::numbers::pi);
  for (const JointGroup& group : figure.groups()) {
    if (group.size == 3) q[group.first.value() + 1] *= 0.5 - 0.5 / std::numbers::pi;
  }
  return q;
}

EndForces RandomEndForces(const Figure& figure, Random* random) {
  const int ends = static_cast<int>(EndJoints(figure).size());
  EndForces forces{Eigen::Matrix3Xd(3, ends), Eigen::Matrix3Xd(3, ends)};
  for (int e = 0; e < ends; ++e) {
    forces.Kf.col(e) = random->Vector3(50.0);
    forces.Kn.col(e) = random->Vector3(20.0);
  }
  return forces;
}

namespace {

Mat3 Turn(int axis, double angle) {
  return AxisRotation<double>(Vec3::Unit(axis), std::sin(angle), std::cos(angle));
}

}  // namespace

Pose MovingRoot::X_WR() const {
  return {Turn(0, angle[0]) * Turn(1, angle[1]) * Turn(2, angle[2]), p};
}

RootMotion MovingRoot::Motion() const {
  RootMotion motion;
  motion.v = v;
  motion.a = a;
  Mat3 R = Mat3::Identity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = R.col(i);
    motion.alpha += axis * acceleration[i] + motion.w.cross(axis) * rate[i];
    motion.w += axis * rate[i];
    R = R * Turn(i, angle[i]);
  }
  return motion;
}

MovingRoot RandomMovingRoot(Random* random) {
  MovingRoot root;
  root.p = random->Vector3(1.0);
  root.v = random->Vector3(2.0);
  root.a = random->Vector3(10.0);
  root.angle = random->Vector3(1.0);
  root.rate = random->Vector3(4.0);
  root.acceleration = random->Vector3(20.0);
  return root;
}

}  // namespace hazumi::test
