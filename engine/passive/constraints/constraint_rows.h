#pragma once

#include <utility>
#include <vector>

#include "engine/passive/constraints/constraint_spec.h"
#include "engine/passive/forces/force_law.h"

namespace hazumi {

// One direction in which a constraint acts: with a force, or a torque where it turns, of size 1
// along n on its end a and along -n on b. World axes; points from the root's origin.
struct ConstraintRow {
  int constraint = 0;
  bool turns = false;
  bool is_closed = false;                                      // there is no gap to close
  int a = ConstraintSeat::kWorld, b = ConstraintSeat::kWorld;  // nodes
  small::V3 r_a, r_b;  // of the points where it acts, from the nodes' origins [m]
  small::V3 n;
  double gap = 0.0, rate = 0.0;  // e, e'
  // e'' = n (a_a - a_b) + bend, of points or turns, and what it is to be.
  double bend = 0.0, wanted = 0.0;
};

// A constraint that gave way [s].
struct ConstraintBreak {
  int constraint;
  double time;
};

// The rows of an island's constraints, those that are broken left out. [METHOD 11]
class ConstraintRows {
 public:
  explicit ConstraintRows(std::vector<ConstraintSpec> specs);

  bool any() const { return num_whole_ > 0; }
  // Whether any has no gap to close.
  bool any_closed() const;
  bool any_yielding() const;
  bool may_break() const;
  double FastestRate() const;  // as ForceLaw has it [1/s]

  // Where the rows are, for nodes that are placed in the world and move. No balls need be known.
  void Measure(const RegionState& state);
  const std::vector<ConstraintRow>& rows() const { return rows_; }

  // What of e'' - wanted slows gaps down, by row.
  VecX Damping() const;

  // Forces or impulses of all constraints, with those of the rows.
  VecX SizesOf(const VecX& forces) const;
  // The one that these sizes are most too much for; -1: none.
  int Overloaded(const VecX& forces, bool are_impulses) const;
  // By how much of what they stand these exceed it, the worst; -1 or more.
  double Overload(const VecX& forces, bool are_impulses) const;
  void Break(int constraint, double t);
  std::vector<ConstraintBreak> TakeBreaks() { return std::exchange(breaks_, {}); }
  const std::vector<ConstraintSpec>& specs() const { return specs_; }

 private:
  void AddPoint(int i, const RegionState& state);
  void AddTurn(int i, const RegionState& state);
  void AddDistance(int i, const RegionState& state);
  ConstraintRow RowOf(int i, const RegionState& state) const;

  std::vector<ConstraintSpec> specs_;
  std::vector<char> is_broken_;
  int num_whole_;
  std::vector<ConstraintRow> rows_;
  std::vector<ConstraintBreak> breaks_;
};

}  // namespace hazumi
