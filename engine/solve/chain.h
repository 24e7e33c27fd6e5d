#pragma once

// Limb as one row of joints, and the moments that its motion needs.
//
// The motion is given frame by frame, h seconds apart. Of frame t, with the frames around it:
//
//   F_k = m_k ((g_k(t+1) - 2 g_k(t) + g_k(t-1)) / h^2 - gravity)
//   N_k = W_k (P(f2) - Q(f1)) / h^2,  f1 and f2: turns to and from t, in the body's frame,
//         P(f) = I f + f x I f / 2, Q(f) = I f - f x I f / 2
//   n_j = sum over k >= j of (g_k - o_j) x F_k + N_k
//
// W: how a body is turned in the world, o: its joint's origin, g: its centre of mass, n_j: the
// moment that joint j gives to what it carries [N m]. [Luh, Walker, Paul 1980] gives the sums from
// the tip inwards. Of a figure of mass M that falls, all F_k have m_k s'' more,
// M s'' = fall - sum over k of m_k g_k''.

#include <vector>

#include "engine/spatial/pose.h"
#include "engine/spatial/rigid_inertia.h"
#include "engine/spatial/types.h"

namespace hazumi::solve {

// An axis about which a joint turns: a unit vector, fixed in the body before it or in its own.
struct TurnAxis {
  Vec3 axis = Vec3::UnitZ();
  bool is_before = false;
};

// Axes of a joint as columns, three at most.
using Axes = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

struct ChainJoint {
  Vec3 offset = Vec3::Zero();  // from the origin before it, in the frame before it [m]
  std::vector<TurnAxis> axes;  // about which its motion is looked for, three at most; none: given
};

// Rotations of the joints of a chain against the body before, by frame and joint.
using Turns = std::vector<std::vector<Mat3>>;

// Velocity that a joint is given at a frame: rate = along . omega, omega [rad/s] being its velocity
// against the body before, in its own frame.
struct GivenRate {
  int frame = 0, joint = 0;
  Vec3 along = Vec3::UnitZ();
  double rate = 0.0;  // [rad/s]
};

struct Chain {
  double step = 1.0 / 30.0;        // from frame to frame [s]
  Vec3 gravity = Vec3::Zero();     // [m/s^2]
  std::vector<ChainJoint> joints;  // from its carrier outwards
  std::vector<Pose> carrier;       // by frame: what the first joint sits on, in the world
  // Inertia that turns with a joint, in its frame, by frame and joint; its mass stays the same.
  std::vector<std::vector<RigidInertia>> bodies;
  std::vector<std::vector<char>> is_known;  // by frame and joint: it keeps its turn
  std::vector<GivenRate> rates;             // with a frame before and one after
  // The first and the last frame stand for the velocities with which the motion arrives and leaves.
  bool has_end_rates = false;
  // Mass of a figure in free fall that the carrier belongs to [kg]; 0: nothing moves the carrier
  // but what is given. `carrier` is then where it is as long as the limb's bodies ask for `fall`,
  // by frame: sum of m_k g_k'' [N]; what they ask for besides moves the whole figure the other way.
  double falling_mass = 0.0;
  std::vector<Vec3> fall;

  int num_frames() const { return static_cast<int>(carrier.size()); }
  int num_joints() const { return static_cast<int>(joints.size()); }
};

// Numbers of a chain's unknowns: of each frame one for each axis, joint by joint.
class ChainUnknowns {
 public:
  explicit ChainUnknowns(const Chain& chain);
  int first(int joint) const { return first_[static_cast<size_t>(joint)]; }
  int size(int joint) const { return first(joint + 1) - first(joint); }
  int per_frame() const { return first_.back(); }

 private:
  std::vector<int> first_;
};

// Bodies of a chain in a frame, in the world; by joint.
struct ChainPose {
  struct Body {
    Mat3 W;     // its rotation
    Vec3 o, g;  // its joint's origin, its centre of mass [m]
    Axes axes;
  };
  std::vector<Body> bodies;
};
ChainPose PoseOfChain(const Chain& chain, int frame, const std::vector<Mat3>& turns);

// Moments of a frame's joints and what they are made of, to be differentiated.
class ChainMoments {
 public:
  // `before`, `now`, `after`: poses of the frames around `frame`.
  ChainMoments(const Chain& chain, int frame, const ChainPose& before, const ChainPose& now,
               const ChainPose& after);

  // About the origin of a joint, world axes [N m].
  const Vec3& moment(int joint) const { return sums_[static_cast<size_t>(joint)].moment; }
  // Torques about the axes of a joint [N m].
  VecX Torques(int joint) const;

  // Derivative of the torques of each joint [N m/rad] by an unknown: axis number `axis` of
  // `joint` in the frame before (-1), in this one (0) or in the one after (1). Fills entries that
  // are numbered as the unknowns of a frame.
  void Differentiate(int at, int joint, int axis, const ChainUnknowns& unknowns,
                     Eigen::Ref<VecX> change);

 private:
  struct Sums {  // from the tip up to a joint, world axes
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  };
  struct OwnForces {
    Vec3 F = Vec3::Zero(), N = Vec3::Zero();
    // Not of a body without mass.
    Vec3 f1, f2;  // turns, in the body's frame
    Mat3 V1, V2;  // TurnVectorChange of these
    Mat3 P, Q;    // derivatives of P(f2) and Q(f1)
  };
  OwnForces ForcesOn(size_t k) const;
  void TakeFall();
  // Changes of F and N of body k with the axis u of `joint`.
  Sums Change(int at, size_t joint, const Vec3& u, size_t k) const;

  const Chain& chain_;
  int frame_;
  const ChainPose *before_, *now_, *after_;
  std::vector<OwnForces> own_;
  std::vector<Sums> sums_;
  std::vector<Vec3>
      levers_;  // of a figure that falls, by joint: sum over k >= j of m_k (g_k - o_j)
};

// Inertia that each joint carries, about its axes: square, of the number of axes [kg m^2].
std::vector<MatX> CarriedInertias(const Chain& chain, int frame, const ChainPose& pose);

// Turns a joint on about its axes by as much as `by` says [rad].
Mat3 TurnedOn(const Mat3& turn, const ChainJoint& joint, const Eigen::Ref<const VecX>& by);
// The axes of a joint in its own frame: columns.
Axes AxesBehind(const Mat3& turn, const ChainJoint& joint);

}  // namespace hazumi::solve
