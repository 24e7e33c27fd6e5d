#pragma once

#include <optional>
#include <vector>

#include "engine/region/equations/tree_impulses.h"
#include "engine/region/exact/step_problem.h"

namespace hazumi {

// Solves the step without A, for limits and for contacts with fixed obstacles. Sweeps from body to
// body on tours of TreeImpulses, in O(nodes + rows) each. [METHOD 12.10]
class TreeStepProblem : public StepProblem {
 public:
  // Requires that `dynamics` outlives this object.
  explicit TreeStepProblem(RegionDynamics* dynamics);

  void Assemble(double t, const HingeState& state) override;
  void Factor() override;
  VecX Rates() const override;
  VecX Accelerations(VecX* x_0) const override;
  double KineticEnergy(const VecX& qd) const override;
  void SetUp(Acting acting, const std::vector<int>& side, const VecX& rows,
             const VecX& hinges) override;
  VecX& b() override { return b_; }
  const std::vector<ConeProblem::Block>& blocks() const override { return blocks_; }
  double Response(int row) const override { return own_[row] + compliance_[row]; }
  void SetResponse(int row, double response) override { compliance_[row] = response - own_[row]; }
  void Sweep(VecX start, bool is_worth_it) override;
  const VecX& forces() const override { return forces_; }
  VecX Velocities() const override { return w_; }
  VecX Jump() const override { return tree_.Rates(); }

 private:
  // Three rows of a contact of a node.
  struct Contact {
    int row, node;
    double friction;
    small::V3 r, n, s, t;     // r from the node's origin [m]; n, s, t along the rows
    double own[3], mixed[3];  // diagonal of A; its entries for n and s, n and t, s and t
  };
  struct Limit {
    int row, node, hinge;
    double side;
  };

  void ListContact(int row, double friction);
  small::V3 VelocitiesAt(const Contact& contact) const;
  TreeImpulses::Impulse ImpulseOf(const Contact& contact, const small::V3& l) const;
  void Settle();
  void Tour();
  void SolveAt(int node);
  void SolveLimitsOf(int node);
  void Solve(const Contact& contact);
  void Solve(const Limit& limit);

  const std::vector<ConstraintRow>& all_rows() const { return dynamics_->rows().rows(); }

  RegionDynamics* dynamics_;
  std::optional<HingeTree> equations_;
  TreeImpulses tree_;
  VecX b_, own_, compliance_, forces_, w_;
  std::vector<ConeProblem::Block> blocks_;
  std::vector<std::vector<Contact>> contacts_;  // one per node
  std::vector<std::vector<Limit>> limits_of_;   // one per node
  double change_ = 0.0;                         // largest velocity change in the latest tour
};

}  // namespace hazumi
