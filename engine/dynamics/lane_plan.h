#pragma once

// A figure prepared for fast dynamics. Concentric hinges with nothing between them are one body,
// and up to four bodies that do not hang on each other (two arms, two legs) are computed at once,
// one in each lane of a vector instruction. What does not change with the pose is worked out here.
//
// Frames. Every body has a frame B at the origin of its joint, with axes along which its hinges
// lie:
//   R_PB = F T1 T2 T3,  each T a turn about a unit vector of B by an angle or minus an angle,
// with P the parent's B and F constant. F is the identity wherever the hinges lie along the axes of
// P when all angles are zero, as in most figures.
//
// Lanes in step. The bodies of a step make the same turns in the same order; a body whose hinges
// come in another order, or that has fewer, sits some of them out.

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "engine/figure/figure.h"

namespace hazumi {

constexpr int kMaxLanes = 4;

// Numbers that vector instructions read and write, aligned for them.
class LaneArray {
 public:
  LaneArray() = default;
  // Zeros.
  explicit LaneArray(size_t size)
      : chunks_((size + kMaxLanes - 1) / kMaxLanes, Chunk{}), size_(size) {}
  // Anything, until it is written: for what is large.
  static LaneArray Unset(size_t size) {
    LaneArray unset;
    unset.chunks_.resize((size + kMaxLanes - 1) / kMaxLanes);
    unset.size_ = size;
    return unset;
  }
  size_t size() const { return size_; }
  double* data() { return chunks_.data()->values; }
  const double* data() const { return chunks_.data()->values; }

 private:
  struct alignas(32) Chunk {
    double values[kMaxLanes];
  };
  // Leaves as it is what is made without a value.
  struct Allocator : std::allocator<Chunk> {
    template <typename Made>
    void construct(Made* at) {
      ::new (static_cast<void*>(at)) Made;
    }
    template <typename Made, typename... Values>
    void construct(Made* at, Values&&... values) {
      ::new (static_cast<void*>(at)) Made(std::forward<Values>(values)...);
    }
    template <typename Other>
    struct rebind {
      using other = Allocator;
    };
  };
  std::vector<Chunk, Allocator> chunks_;
  size_t size_ = 0;
};

struct LaneHinge {
  JointIndex joint;
  int axis = 0;       // the unit vector of B it lies along
  double sign = 1.0;  // -1: it turns the other way
};

// One body of the plan: one to three concentric hinges and the inertia beyond the last.
struct LaneBody {
  int parent = -1;  // in LanePlan::bodies; -1: the root
  std::vector<LaneHinge> hinges;
  Mat3 F = Mat3::Identity();
  Vec3 p_PB = Vec3::Zero();      // in P [m]
  Mat3 R_JB = Mat3::Identity();  // B in the frame of its last hinge
  RigidInertia inertia;          // in B
  int step = 0, lane = 0;

  JointIndex last() const { return hinges.back().joint; }
};

// Constant fields of a step, one value a lane each: F by rows, p_PB, m, m c, and the inertia about
// the origin (diagonal, then the entries yz, zx, xy).
struct LaneConstants {
  enum Field { kF = 0, kOrigin = 9, kMass = 12, kMoment = 13, kInertia = 16 };
  static constexpr int kFields = 22;
};

// Scratch fields of a step. `motion` is w, alpha and a of B's origin; `load` the moment and the
// force that the body asks of its parent.
struct LaneState {
  enum Field { kMotion = 0, kLoad = 9 };
  static constexpr int kLoadFields = 6;
  static constexpr int kFields = kLoad + kLoadFields;
};

// Scratch fields of a turn, called its row. `given` is qdd, and then tau.
struct LaneRow {
  enum Field { kCosine = 0, kSine = 1, kRate = 2, kGiven = 3 };
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
  int first_row = 0, end_row = 0;
  bool turned = false;   // some F is not the identity
  bool shifted = false;  // some p_PB is not zero
};

struct LanePlan {
  explicit LanePlan(const Figure& figure);

  int width = 1;  // lanes: 1 or 4
  std::vector<LaneBody> bodies;
  std::vector<LaneStep> steps;
  std::vector<LaneSource> children;
  std::vector<int> row_axis;  // by row: the axis of the turn
  // One entry a row and lane: whose hinge it is and its sign, 0 and 0 where it sits out.
  std::vector<int> row_joint;
  LaneArray row_sign;
  // By joint: where its row is in the scratch array, in its lane, and its sign.
  std::vector<int> joint_at;
  std::vector<double> joint_sign;
  LaneArray constants;  // steps x LaneConstants::kFields x width

  int num_rows() const { return static_cast<int>(row_axis.size()); }
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
