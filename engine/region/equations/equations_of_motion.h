#pragma once

#include <vector>

#include "engine/region/equations/dense_equations.h"
#include "engine/region/equations/tree_equations.h"
#include "engine/region/region_laws.h"

namespace hazumi {

class EquationsOfMotion;

// How the equations of motion of an instant are solved: with their matrix, which takes n^3, or by
// articulated bodies, in O(n).
enum class EquationsMethod : char { kDense, kTree };

// The third stage: M x + b = 0 for the directions of a layout at one instant, returned by
// EquationsOfMotion. Those by tree are solved as well. Valid until the next ones are assembled.
class AssembledEquations {
 public:
  const RegionState& state() const { return state_; }
  const RegionLayout& layout() const { return state_.layout; }
  EquationsMethod method() const { return method_; }
  // Unknowns of responses: by tree the translation of a root that flies, then the directions.
  int num_unknowns() const;

  // Prepares AddToRow.
  void PrepareRows() const;
  // Adds to `column` what the unknowns do to a point of a node, r from the node's origin, along n,
  // or to the turning of the node about n. By tree L^-1 times that, with M = L L^T. By matrix
  // without what the root responds.
  void AddToRow(int node, const small::V3& r, const small::V3& n, bool turns,
                Eigen::Ref<VecX> column) const;
  // Adds what the root responds, by matrix only. `along`, by row, is how the points of a row move
  // with the root.
  void AddRootToRows(const Eigen::Matrix3Xd& along, Eigen::Ref<MatX> rows) const;
  // The root's acceleration in flight less gravity's, with accelerations x, which the nodes have.
  small::V3 RootAcceleration(const double* x) const;
  // Sets the accelerations that a law that is a rule adds. A root that turns freely responds so
  // that the angular momentum stays.
  void FindRule(const ForceLaw& rule, VecX* added) const;
  // Adds those of all rules to x, by direction.
  void AddRules(const RegionLaws& laws, double* x) const;

 protected:
  friend class EquationsOfMotion;
  AssembledEquations(EquationsOfMotion* equations, EquationsMethod method, const RegionState& state)
      : equations_(equations), method_(method), state_(state) {}

  void KeepAngularMomentum(VecX* added) const;

  EquationsOfMotion* equations_;
  EquationsMethod method_;
  RegionState state_;
};

// Equations of motion whose matrix is factored, M = L L^T, by matrix or by tree.
class SolvedEquations : public AssembledEquations {
 public:
  // Replaces columns of AddToRow by L^-1 times them. By tree they are that already.
  void FinishHalves(Eigen::Ref<MatX> columns) const;
  // Returns accelerations of the directions for such a half, L^-T half; overwrites it.
  VecX Respond(VecX half) const;

 private:
  friend class EquationsOfMotion;
  using AssembledEquations::AssembledEquations;
};

// Assembles and solves the equations of motion of an island.
class EquationsOfMotion {
 public:
  // `model` must outlive this object.
  explicit EquationsOfMotion(const RegionModel* model)
      : model_(model), dense_(*model), tree_(*model), added_(model->num_free) {}

  // Sets x = -M^-1 b, by direction of the layout. A direction that moves no mass gets 0.
  SolvedEquations Solve(const LoadedState& loaded, EquationsMethod method, double* x);
  // Assembles M and b.
  AssembledEquations Assemble(const LoadedState& loaded);
  // Factors M.
  SolvedEquations Factor(const AssembledEquations& assembled);
  // Assembles M and b of some free hinges alone, with the others following freely.
  void AssembleSome(const LoadedState& loaded, const std::vector<int>& hinges);

  const DenseEquations& dense() const { return dense_; }
  const TreeEquations& tree() const { return tree_; }
  TreeEquations& tree() { return tree_; }

 private:
  friend class AssembledEquations;
  friend class SolvedEquations;
  Mat3 InertiaOfRoot(const RegionState& state, const VecX& added, Vec3* moment);

  const RegionModel* model_;
  DenseEquations dense_;
  TreeEquations tree_;
  std::vector<small::V3> alpha_, a_;  // scratch, by node
  VecX added_;                        // scratch, by direction
};

}  // namespace hazumi
