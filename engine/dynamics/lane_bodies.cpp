#include "engine/dynamics/lane_bodies.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/base/assert.h"

// Hinges about b1, b2, b3 (in the frame J of the last, all angles zero) with constant turns between
// them are one constant turn followed by turns about the b. With E = R_JB the axes chosen for B,
//   R_PB = E_P^T (X_PJ1.R X_J1J2.R X_J2J3.R) E  T1 T2 T3,
// each T a turn about E^T b, which E makes a unit vector.

namespace hazumi {

namespace {

// Rounding of axes that were meant to be perpendicular, or along each other.
constexpr double kRounding = 1e-14;

// Hinges that will be one body.
struct Chain {
  JointIndex parent;
  std::vector<JointIndex> hinges;
  std::vector<Vec3> axes;        // in the frame J of the last hinge, angles zero
  Mat3 R_PJ = Mat3::Identity();  // of the last hinge, angles zero
};

bool ArePerpendicular(const std::vector<Vec3>& axes, const Vec3& axis) {
  for (const Vec3& other : axes) {
    if (std::abs(other.dot(axis)) > kRounding) return false;
  }
  return true;
}

// True if joint j has the same origin as the last hinge of `chain` and nothing else hangs there.
bool Continues(const Figure& figure, const Chain& chain, int j) {
  const Joint& joint = figure.joints()[j];
  if (chain.hinges.size() >= 3 || joint.parent != chain.hinges.back()) return false;
  const Joint& before = figure.joint(joint.parent);
  if (!before.massless || before.subtree_end != joint.subtree_end) return false;
  if (!joint.X_PJ.p.isZero(0.0)) return false;
  std::vector<Vec3> axes = chain.axes;
  for (Vec3& axis : axes) axis = joint.X_PJ.R.transpose() * axis;
  return ArePerpendicular(axes, joint.axis);
}

void Append(const Figure& figure, int j, Chain* chain) {
  const Joint& joint = figure.joints()[j];
  for (Vec3& axis : chain->axes) axis = joint.X_PJ.R.transpose() * axis;
  chain->R_PJ = chain->R_PJ * joint.X_PJ.R;
  chain->axes.push_back(joint.axis);
  chain->hinges.emplace_back(j);
}

std::vector<Chain> FindChains(const Figure& figure) {
  std::vector<Chain> chains;
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (chains.empty() || !Continues(figure, chains.back(), j)) {
      chains.emplace_back();
      chains.back().parent = figure.joints()[j].parent;
    }
    Append(figure, j, &chains.back());
  }
  return chains;
}

// Gives the body its hinges if, with these axes, each lies along one.
bool TakeAxes(const Chain& chain, const Mat3& R_JB, LaneBody* body) {
  body->R_JB = R_JB;
  body->hinges.clear();
  for (size_t h = 0; h < chain.axes.size(); ++h) {
    const Vec3 axis = R_JB.transpose() * chain.axes[h];
    LaneHinge hinge{chain.hinges[h]};
    axis.cwiseAbs().maxCoeff(&hinge.axis);
    hinge.sign = axis[hinge.axis] < 0.0 ? -1.0 : 1.0;
    const Vec3 rest = axis - hinge.sign * Vec3::Unit(hinge.axis);
    if (rest.cwiseAbs().maxCoeff() > kRounding) return false;
    body->hinges.push_back(hinge);
  }
  return true;
}

// Axes that suit the hinges whatever the parent's.
Mat3 OwnAxes(const Chain& chain) {
  Mat3 E;
  E.col(0) = chain.axes[0];
  const Vec3 second = chain.axes.size() > 1 ? chain.axes[1] : chain.axes[0].unitOrthogonal();
  E.col(1) = (second - second.dot(E.col(0)) * E.col(0)).normalized();
  E.col(2) = E.col(0).cross(E.col(1));
  return E;
}

RigidInertia Turned(const RigidInertia& inertia, const Mat3& R_JB) {
  return {inertia.mass, R_JB.transpose() * inertia.com, R_JB.transpose() * inertia.I_com * R_JB};
}

// `R_PB`: the parent's own R_JB.
LaneBody BodyOf(const Figure& figure, const Chain& chain, const Mat3& R_PB) {
  LaneBody body;
  if (!TakeAxes(chain, chain.R_PJ.transpose() * R_PB, &body)) {
    HAZUMI_DEMAND(TakeAxes(chain, OwnAxes(chain), &body));
    body.F = R_PB.transpose() * chain.R_PJ * body.R_JB;
  }
  body.p_PB = R_PB.transpose() * figure.joint(chain.hinges.front()).X_PJ.p;
  body.inertia = Turned(figure.body(body.last()), body.R_JB);
  return body;
}

}  // namespace

std::vector<LaneBody> MergeConcentricHinges(const Figure& figure) {
  const std::vector<Chain> chains = FindChains(figure);
  std::vector<LaneBody> bodies;
  std::vector<int> body_of(figure.num_joints(), -1);  // by its last hinge
  for (const Chain& chain : chains) {
    const int parent = chain.parent.is_valid() ? body_of[chain.parent.value()] : -1;
    bodies.push_back(
        BodyOf(figure, chain, parent < 0 ? Mat3(Mat3::Identity()) : bodies[parent].R_JB));
    bodies.back().parent = parent;
    body_of[chain.hinges.back().value()] = static_cast<int>(bodies.size()) - 1;
  }
  return bodies;
}

}  // namespace hazumi
