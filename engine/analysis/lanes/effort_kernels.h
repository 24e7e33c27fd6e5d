#pragma once

#include "engine/figure/strength.h"

// Internal. What effort asks most often, by lanes of four: of four frames, four contacts, or four
// series. Both instruction sets give the same bits; all arrays of lanes are aligned to 32 bytes.

namespace hazumi {

// Of a body: its axes, one after the other, and its origin.
inline constexpr int kPlacedFields = 12;

// A joint as the kernels read it.
struct PlacedHinge {
  int parent = 0;            // body: 0 is the root, j + 1 the body of joint j
  bool is_parallel = true;   // R_PJ is the identity
  bool is_shifted = true;    // p_PJ is not zero
  bool is_massless = false;  // the body beyond it
  int unit_axis = -1;        // the axis of J that it turns about, or against; -1: another one
  double sign = 1.0;         // -1: against it
  double R_PJ[9];            // by columns
  double p_PJ[3];            // [m]
  double axis[3];            // unit, in J
};

// Of a body in a frame: its mass, its centre of mass and the moments of inertia about that, which
// are the diagonal and then the entries yz, zx, xy; all in its own frame.
struct InertiaField {
  enum Field { kMass = 0, kCom = 1, kInertia = 4 };
  static constexpr int kNumFields = 10;
};

// How a figure moves in four frames, for inverse dynamics. Bodies as PlacedHinge::parent; of each
// `placed`, InertiaField, w, alpha and a of its origin (of the root given), and the load: force and
// moment that it asks for there, all in world axes, by field and frame.
struct FourMotions {
  const PlacedHinge* hinges = nullptr;
  int num_hinges = 0;
  const double *placed = nullptr, *inertias = nullptr;
  const double *rates[4], *accelerations[4];  // by frame and joint
  double *motions = nullptr, *loads = nullptr;
  double* needed = nullptr;   // the load of the whole figure on its root
  double* torques = nullptr;  // by joint and frame
};
inline constexpr int kMotionFields = 9, kLoadFields = 6;

// A ball on a body, as the kernels read it.
struct TouchingBall {
  int body = 0;      // as PlacedHinge::parent
  double centre[3];  // in the body's frame [m]
  double radius = 0.0;
};

// What balls touch: the half-space normal . x <= offset, or a box grown by a margin.
struct TouchedShape {
  bool is_plane = true;
  double normal[3], offset = 0.0;
  double R_WB[9];  // of the box, by columns
  double p_WB[3], half_size[3], margin = 0.0;
};

// Of a ball in four frames: its centre, and the normal from the nearest shape to it, unit.
struct TouchField {
  enum Field { kCentre = 0, kNormal = 3 };
  static constexpr int kNumFields = 6;
};

// What the kernels read of four contacts, and what they leave, by field and contact: bits are all
// set or none.
struct ConeField {
  enum Given { kArm = 0, kNormal = 3, kWeight = 6, kGripBits = 7 };
  static constexpr int kNumGiven = 8;
  enum Found { kInsideBits = 0, kSideBits = 1, kForce = 2 };
  static constexpr int kNumFound = 5;
  // Summed up over contacts: s, the lower half of its derivative by columns, and the function that
  // s is the gradient of.
  enum Sum { kSupplied = 0, kSlope = 6, kPotential = 27 };
  static constexpr int kNumSums = 28;
};

// What the kernels read of a hinge whose torques are told as shares of its strength.
struct HingeStrength {
  const JointStrength* strength = nullptr;  // null: not known
  double lower = 0.0, upper = 0.0;          // its stops [rad]
};

// low_pass.cpp has the equations; so many series are filtered at once.
struct LowPassFilter {
  double b, a1, a2;
};
inline constexpr int kFiltered = 8;

struct EffortKernels {
  // `angles`: by frame and joint [rad]. `placed`: by body, field and frame, that of the root set
  // before.
  void (*place)(const PlacedHinge* hinges, int num_hinges, const double* const angles[4],
                double* placed);
  // Motions, loads without those of the bodies beyond, and what is needed; then torques, for which
  // loads may have been lessened by what pushes the bodies from outside.
  void (*demand)(const FourMotions& four);
  void (*relay)(const FourMotions& four);
  // `placed`: of four frames. `touches`: by ball, TouchField and frame. `clearances`: of the
  // nearest shape, four of each ball, those of the next one `stride` numbers further [m].
  void (*touch)(const TouchingBall* balls, int num_balls, const TouchedShape* shapes,
                int num_shapes, const double* placed, double* touches, double* clearances,
                long stride);
  // contact_forces.cpp has the equations. `y`: six numbers. With `keeps` each force goes on as in
  // the part of its cone that `found` has; false: these are not the parts where all are.
  bool (*supply)(const double* given, int num_fours, const double* y, double friction, bool keeps,
                 double* found, double* sums);
  // x: of (A + softness 1) x = b, A positive semidefinite, of which there is the lower half by
  // columns. Six numbers, b before, x then.
  void (*solve)(const double* lower, double softness, double* x);
  // Of `torques` by joint and frame what FrameEffort::share has; `least`: 1 where that is of the
  // least strength, else 0. Both likewise.
  void (*share)(const HingeStrength* hinges, int num_hinges, const double* torques,
                const double* const angles[4], const double* const rates[4], double* shares,
                double* least);
  // By sample and series.
  void (*low_pass)(const LowPassFilter& filter, long count, double* series);
  // Of so many numbers from x on, of which those one frame earlier and later are `stride` numbers
  // off and h apart in time [s]: rates and accelerations there. Nothing need be aligned.
  void (*differentiate)(const double* x, long count, long stride, double h, double* rates,
                        double* accelerations);
};
EffortKernels BaselineEffortKernels();
EffortKernels Avx2EffortKernels();
EffortKernels BestEffortKernels();  // of this machine

}  // namespace hazumi
