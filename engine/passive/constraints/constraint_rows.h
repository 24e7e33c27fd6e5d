#pragma once

#include <utility>
#include <vector>

#include "engine/passive/constraints/constraint_row.h"
#include "engine/passive/forces/force_law.h"

namespace hazumi {

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
  // After Measure: for contacts to append theirs.
  std::vector<ConstraintRow>* mutable_rows() { return &rows_; }

  // What of e'' - wanted slows gaps down, by row.
  VecX Damping() const;

  // Forces or impulses of all constraints, with those of the rows.
  VecX SizesOf(const VecX& forces) const;
  // The constraint that forces or impulses are most too much for, or nearest to it, and by how much
  // of what it stands they exceed that, -1 or more. No constraint that can break: -1.
  struct Overload {
    int constraint = -1;
    double excess = -1.0;
  };
  Overload WorstOverload(const VecX& forces, bool are_impulses) const;
  void Break(int constraint, double t);
  bool is_broken(int constraint) const { return is_broken_[static_cast<size_t>(constraint)] != 0; }
  std::vector<ConstraintBreak> TakeBreaks() { return std::exchange(breaks_, {}); }
  const std::vector<ConstraintSpec>& specs() const { return specs_; }

 private:
  template <typename Predicate>
  bool AnyWhole(Predicate&& is_one) const;
  void AddPoint(int i, const RegionState& state);
  void AddTurn(int i, const RegionState& state);
  void AddDistance(int i, const RegionState& state);
  ConstraintRow RowOf(int i, const small::V3& r_a, const small::V3& r_b) const;

  std::vector<ConstraintSpec> specs_;
  std::vector<char> is_broken_;
  int num_whole_;
  std::vector<ConstraintRow> rows_;
  std::vector<ConstraintBreak> breaks_;
};

}  // namespace hazumi
