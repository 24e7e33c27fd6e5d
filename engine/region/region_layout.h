#pragma once

#include <array>
#include <vector>

#include "engine/region/hinge_triple.h"
#include "engine/region/region_model.h"

namespace hazumi {

// A hinge that a region frees.
struct FreeHinge {
  Coordinate coordinate;
  int node, slot;  // which hinge of which node
};

// How the free joints of a model make up a state y: positions, then velocities. A ball joint is a
// quaternion (w, x, y, z) and an angular velocity in the body's frame, any other free hinge its
// angle and rate. A locked hinge is no part of it; a ball one of whose hinges is locked goes on as
// two hinges.
class RegionLayout {
 public:
  enum class NodeKind : char { kStill, kDriven, kHinges, kBall };
  struct Node {
    NodeKind kind = NodeKind::kStill;
    int position = 0;  // of its first in the positions
    int dof = 0;       // of its first in the velocities
    int num_dofs = 0;
    int first_hinge = 0;            // among the free hinges
    int first_angle = 0;            // in angles(), of those that are not a ball's or locked
    std::array<bool, 3> locked{};   // by hinge of the node
    std::array<double, 3> angle{};  // as SetLocked was told last [rad]
    std::array<double, 3> sine{}, cosine{};  // of the locked ones
  };

  // Nothing locked. `balls`: without it every joint is a chain of hinges, and a state is the angles
  // and rates of the free hinges.
  RegionLayout(const RegionModel& model, bool balls);

  // `angles`, by hinge [rad]: of those that are locked; the others' tell on which side of its poles
  // a ball joint is.
  void SetLocked(const std::vector<char>& locked, const VecX& angles);

  const std::vector<FreeHinge>& hinges() const { return hinges_; }
  int num_hinges() const { return static_cast<int>(hinges_.size()); }
  const Node& node(int i) const { return nodes_[i]; }
  const std::vector<Node>& nodes() const { return nodes_; }
  // Null unless the node is a ball.
  const HingeTriple* triple(int node) const;
  // Null unless the node would be a ball with nothing locked.
  const HingeTriple* unlocked_triple(int node) const;
  int num_positions() const { return num_positions_; }
  int num_dofs() const { return num_dofs_; }
  bool is_any_locked() const { return num_dofs_ < num_hinges(); }
  int state_size() const { return num_positions_ + num_dofs_; }
  // Which positions are angles.
  const std::vector<int>& angles() const { return angles_; }
  bool is_quaternion(int position) const { return is_quaternion_[position]; }

  // Sets the derivatives of the positions, from the velocities.
  void DerivePositions(const double* y, double* dy) const;
  // Turns the free joints of a state on by small angles, by dof.
  void Turn(const VecX& change, double* y) const;
  // Angles and rates of the free hinges as a state.
  void Pack(const VecX& q, const VecX& qd, double* y) const;
  // And back. `q` on entry: angles nearby, which pick branch and turn of ball joints. `lower`,
  // `upper`: limits; a ball joint that has any keeps its side, as HingeTriple::Angles.
  void Unpack(const double* y, const VecX& lower, const VecX& upper, VecX* q, VecX* qd) const;

  // The same of one node's hinges alone.
  void UnpackNode(int node, const double* y, const VecX& lower, const VecX& upper, VecX* q,
                  VecX* qd) const;
  // Accelerations of the free hinges at q and qd for those of the velocities, `x` by dof; 0 of
  // locked ones.
  void UnpackAccelerations(const double* x, const VecX& q, const VecX& qd, VecX* qdd) const;
  // The first free hinge of the node that a component of the state belongs to.
  int HingeOf(int component) const;

  // By free hinge: how far two poses are apart [rad]; for the hinges of a ball joint, the angle
  // between the two orientations.
  void Distances(const VecX& q, const VecX& other, VecX* distances) const;

 private:
  std::vector<int> num_hinges_of_;  // by node, free ones
  std::vector<FreeHinge> hinges_;
  std::vector<HingeTriple> triples_;
  std::vector<int> triple_of_;  // by node, -1: none
  std::vector<Node> nodes_;
  std::vector<char> is_quaternion_;  // by position
  std::vector<int> angles_;
  int num_positions_ = 0, num_dofs_ = 0;
};

// The rotation of a quaternion (w, x, y, z) of any length but zero.
Mat3 RotationOfQuaternion(const double* q);

}  // namespace hazumi
