#pragma once

#include "engine/passive/exact/step_problem.h"
#include "engine/passive/tree_impulses.h"

namespace hazumi {

// Without A, for contacts of bodies with what does not move and for limits: sweeps from body to
// body on tours of TreeImpulses, in O(nodes + rows) each. [METHOD 12.10]
class TreeStepProblem : public StepProblem {
 public:
  // `dynamics` must outlive it.
  explicit TreeStepProblem(RegionDynamics* dynamics);

  void Assemble(double t, const VecX& q, const VecX& qd) override;
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
  // Three rows of a contact with a node.
  struct Contact {
    int row, node;
    double friction;
    small::V3 r, n, s, t;     // from the node's origin [m]; along the rows
    double own[3], mixed[3];  // A of the three, A of n and s, n and t, s and t
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

  RegionDynamics* dynamics_;
  TreeImpulses tree_;
  VecX x_0_, accelerations_;
  VecX b_, own_, compliance_, forces_, w_;
  std::vector<ConeProblem::Block> blocks_;
  std::vector<std::vector<Contact>> contacts_;  // by node
  std::vector<std::vector<Limit>> limits_of_;   // by node
  double change_ = 0.0;                         // of any velocity, in the latest tour
};

}  // namespace hazumi
