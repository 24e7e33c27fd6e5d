#pragma once

// A figure prepared for fast dynamics. Concentric hinges with nothing between them are one body,
// and up to four bodies that do not hang on each other (two arms, two legs) are computed at once,
// one in each lane of a vector instruction. What does not change with the pose is worked out here.
//
// Frames. Every body has a frame B at the origin of its joint, its axes e1, e2, e3 chosen so that
// its hinges turn about them, in this order ("slots" 0, 1, 2; a body need not use all):
//   R_PB = F X(s1 q1) Y(s2 q2) Z(s3 q3),
// with P the parent's B, F constant and each s = 1 or -1. In most figures F is the identity.

#include <array>
#include <vector>

#include "engine/figure/figure.h"

namespace hazumi {

constexpr int kMaxLanes = 4;

// Numbers that vector instructions read and write, aligned for them.
class LaneArray {
 public:
  LaneArray() = default;
  explicit LaneArray(size_t size) : chunks_((size + kMaxLanes - 1) / kMaxLanes), size_(size) {}
  size_t size() const { return size_; }
  double* data() { return chunks_.data()->values; }
  const double* data() const { return chunks_.data()->values; }

 private:
  struct alignas(32) Chunk {
    double values[kMaxLanes] = {0.0, 0.0, 0.0, 0.0};
  };
  std::vector<Chunk> chunks_;
  size_t size_ = 0;
};

// One body of the plan: one to three concentric hinges and the inertia beyond the last.
struct LaneBody {
  int parent = -1;                            // in LanePlan::bodies; -1: the root
  std::array<JointIndex, 3> hinge;            // by slot; invalid where the slot is not used
  std::array<double, 3> sign = {0., 0., 0.};  // of the hinge's angle
  JointIndex last;                            // the hinge that carries the body
  Mat3 F = Mat3::Identity();
  Vec3 p_PB = Vec3::Zero();  // in P [m]
  Mat3 R_JB = Mat3::Identity();
  RigidInertia inertia;  // in B
  int step = 0, lane = 0;
};

// Constant fields of a step, each one value a lane.
struct LaneConstants {
  enum Field { kF = 0, kOrigin = 9, kMass = 12, kMoment = 13, kInertia = 16, kUsed = 22 };
  static constexpr int kFields = 25;
};

// Scratch fields of a step. `motion` is w, alpha and a of B's origin at given accelerations;
// `response` alpha and a that torques add; `load` what the body asks of its parent: moment, force
// and articulated inertia (J, H, M); `pivot` what elimination leaves of each slot.
struct LaneState {
  enum Field { kMotion = 0, kResponse = 9, kLoad = 15, kPivot = 42 };
  static constexpr int kLoadFields = 27, kForceFields = 6, kPivotFields = 7;
  static constexpr int kFields = kPivot + 3 * kPivotFields;
};

// Scratch fields of a slot that a step uses: its row.
struct LaneRow {
  enum Field { kCosine = 0, kSine = 1, kRate = 2, kGiven = 3 };  // kGiven: qdd or tau, in and out
  static constexpr int kFields = 4;
};

// Where each lane reads: offsets in the scratch array.
struct LaneSource {
  std::array<int, kMaxLanes> from = {0, 0, 0, 0};
  bool contiguous = false;  // from[0], from[0] + 1, ...
};

// Up to four bodies whose parents were all done in earlier steps.
struct LaneStep {
  LaneSource parent;                   // its motion
  int first_child = 0, end_child = 0;  // in LanePlan::children: loads to add up
  int first_row = 0;
  int slots = 0;         // bit k: some lane has a hinge in slot k
  bool turned = false;   // some F is not the identity
  bool shifted = false;  // some p_PB is not zero
  bool at_root = false;  // every parent is the root
};

struct LanePlan {
  explicit LanePlan(const Figure& figure);

  int width = 1;                 // lanes: 1 or 4
  Mat3 R_RB = Mat3::Identity();  // axes in which the root's motion is handed to the first steps
  std::vector<LaneBody> bodies;
  std::vector<LaneStep> steps;
  std::vector<LaneSource> children;
  // One entry a row and lane: whose hinge it is and its sign, 0 and 0 where none.
  std::vector<int> row_joint;
  LaneArray row_sign;
  std::vector<int> joint_cell;  // by joint: its entry
  LaneArray constants;          // steps x LaneConstants::kFields x width

  int num_rows() const { return static_cast<int>(row_joint.size()) / width; }
  // The scratch array: states of the root and the steps, an empty load, rows.
  int state(int step) const { return (step + 1) * LaneState::kFields * width; }
  int root_state() const { return 0; }
  int empty_load() const { return state(static_cast<int>(steps.size())); }
  int row(int r) const {
    return empty_load() + (LaneState::kLoadFields + r * LaneRow::kFields) * width;
  }
  int scratch_size() const { return row(num_rows()); }
};

}  // namespace hazumi
