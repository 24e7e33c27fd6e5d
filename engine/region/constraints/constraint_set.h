#pragma once

#include <utility>
#include <vector>

#include "engine/region/constraints/constraint_row.h"
#include "engine/region/forces/force_law.h"

namespace hazumi {

// The constraints of an island, and which of them are broken. [METHOD 11]
class ConstraintSet {
 public:
  explicit ConstraintSet(std::vector<ConstraintSpec> specs);

  const std::vector<ConstraintSpec>& specs() const { return specs_; }
  // The following are about constraints that are not broken.
  bool any() const { return num_whole_ > 0; }
  bool any_closed() const;   // without a gap to close
  bool any_closing() const;  // with one
  bool may_break() const;
  double FastestRate() const;  // as ForceLaw has it [1/s]

  // Appends the rows for nodes that are placed in the world.
  void AppendRows(const RegionState& state, std::vector<ConstraintRow>* rows) const;
  // The part of e'' - wanted that slows gaps down, by row.
  VecX Damping(const std::vector<ConstraintRow>& rows) const;

  // Magnitudes of the forces or impulses of all constraints, with those of the rows.
  VecX SizesOf(const std::vector<ConstraintRow>& rows, const VecX& forces) const;
  // The constraint whose forces or impulses exceed its strength most, or come nearest to it, and by
  // how much of its strength, -1 or more. No constraint can break: -1.
  struct Overload {
    int constraint = -1;
    double excess = -1.0;
  };
  Overload WorstOverload(const std::vector<ConstraintRow>& rows, const VecX& forces,
                         bool are_impulses) const;
  void Break(int constraint, double t);
  bool is_broken(int constraint) const { return is_broken_[static_cast<size_t>(constraint)] != 0; }
  // Returns the breaks since the previous call.
  std::vector<ConstraintBreak> TakeBreaks() { return std::exchange(breaks_, {}); }

 private:
  using Rows = std::vector<ConstraintRow>;
  template <typename Predicate>
  bool AnyWhole(Predicate&& is_one) const;
  void AddPoint(int i, const RegionState& state, Rows* rows) const;
  void AddTurn(int i, const RegionState& state, Rows* rows) const;
  void AddDistance(int i, const RegionState& state, Rows* rows) const;
  ConstraintRow RowOf(int i, const small::V3& r_a, const small::V3& r_b) const;

  std::vector<ConstraintSpec> specs_;
  std::vector<char> is_broken_;
  int num_whole_;
  std::vector<ConstraintBreak> breaks_;
};

}  // namespace hazumi
