#pragma once

#include "engine/region/constraints/constraint_spec.h"
#include "engine/spatial/small.h"

namespace hazumi {

// One direction in which a constraint or a contact acts: with a force, or a torque where it turns,
// of size 1 along n on its end a and along -n on b. World axes; points from the root's origin.
struct ConstraintRow {
  static constexpr int kContact = -1;
  int constraint = 0;  // or kContact
  int contact = 0;     // of a ContactSet
  bool turns = false;
  bool is_across = false;                                      // of a contact, not along its normal
  bool is_closed = false;                                      // there is no gap to close
  int a = ConstraintSeat::kWorld, b = ConstraintSeat::kWorld;  // nodes
  small::V3 r_a, r_b;  // of the points where it acts, from the nodes' origins [m]
  small::V3 n;
  small::V3 push;                // kContact: along this instead, on a
  double gap = 0.0, rate = 0.0;  // e, e'
  // e'' = n (a_a - a_b) + bend, of points or turns, and what it is to be.
  double bend = 0.0, wanted = 0.0;

  bool is_contact() const { return constraint == kContact; }
  const small::V3& force() const { return is_contact() ? push : n; }
};

}  // namespace hazumi
