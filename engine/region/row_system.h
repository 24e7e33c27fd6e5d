#pragma once

#include <vector>

#include "engine/region/constraints/row_compliance.h"
#include "engine/region/contact/contact_push.h"
#include "engine/region/equations/equations_of_motion.h"
#include "engine/region/exact/limit_rows.h"
#include "engine/region/free_bodies.h"
#include "engine/region/region_kinematics.h"
#include "engine/region/region_mode.h"

namespace hazumi {

// Jacobians of rows, one column each, returned by RowSystem::Assemble. Rows measure along J and
// push along P; G is what responds besides the hinges.
struct RowMatrices {
  MatX J, P, G;
  bool any_slides = false;  // else P is J, and empty
  const MatX& push() const { return any_slides ? P : J; }
};

// Response of an island to forces of its rows, returned by RowSystem::Respond:
//   A = J M^-1 P^T + G,   half = L^-1 P^T with M = L L^T
struct RowResponse {
  MatX A, half;
};

// The fourth stage: constraints and contacts as rows of the equations of motion of an instant, and
// the forces that keep them. [METHOD 11, 12]
class RowSystem {
 public:
  // `model` must outlive this object.
  RowSystem(const RegionModel* model, const FreeBodies& bodies) : model_(model), bodies_(bodies) {}

  // Lists the rows in a state. `may_slide`: else no force of a contact leans backwards.
  const std::vector<ConstraintRow>& Measure(const RegionMode& mode, const RegionState& state,
                                            bool may_slide = true);
  // Returns e'' - wanted of the measured rows with accelerations x of the directions, which are
  // added to the motion of the nodes.
  VecX Errors(const AssembledEquations& equations, const double* x,
              RegionKinematics* kinematics) const;
  // Assembles the measured rows.
  const RowMatrices& Assemble(const AssembledEquations& equations);
  // The same of closed rows alone, with zeros for others, which act by no impulse.
  const RowMatrices& LeaveClosed();
  const RowResponse& Respond(const RowMatrices& matrices, const SolvedEquations& equations);
  // Returns forces l with A l = -errors.
  VecX Solve(const RegionMode& mode, const MatX& A, const VecX& errors) const;

  // Finds the compliance of rows that have a gap to close, for equations in which no limit locks a
  // hinge.
  void FindCompliance(const RegionMode& mode, const RowResponse& response);
  // Adds what the forces of the rows do to accelerations x of the directions.
  void Constrain(const RegionMode& mode, const SolvedEquations& equations,
                 RegionKinematics* kinematics, double* x);
  // Rows for limits and impacts, by free hinge. `rules`: accelerations of laws that are rules.
  void AssembleForHinges(const RegionMode& mode, const AssembledEquations& equations,
                         const VecX& rules, RegionKinematics* kinematics,
                         EquationsOfMotion* of_motion);
  const LimitRows& for_forces() const { return for_forces_; }
  const LimitRows& for_impulses() const { return for_impulses_; }

  // Rows of the latest measurement, and their forces in the latest Constrain [N, N m].
  const std::vector<ConstraintRow>& rows() const { return rows_; }
  const VecX& forces() const { return forces_; }
  enum class Kind { kAll, kConstraints, kContacts };
  void AddForces(Kind kind, NodeKinematics* nodes) const;
  // Largest part of a contact's force outside of its friction cone, and the sum of all normal
  // forces [N].
  struct Excess {
    double newtons = 0.0, pushes = 0.0;
    double share() const { return pushes > 0.0 ? newtons / pushes : 0.0; }
  };
  Excess ContactExcess(const ContactSet& contacts) const;
  // Contact forces of the latest Constrain, and those of time stepping.
  std::vector<ContactPush> ContactPushes(const RegionMode& mode, const RegionState& state) const;
  // Eigenvalues of the response of closed rows of constraints in the latest Constrain, smallest
  // first, scaled so that a well-conditioned direction has about 1, and a singular one 0; with the
  // constraint that dominates the direction.
  struct Eigenvalue {
    double value;
    int constraint;
  };
  std::vector<Eigenvalue> Spectrum() const;

 private:
  void AddToRow(const AssembledEquations& equations, const ConstraintRow& row, const small::V3& n,
                Eigen::Ref<VecX> column) const;
  VecX Softness(const ContactSet& contacts) const;
  small::V3 AccelerationAt(const NodeKinematics& nodes, int node, const small::V3& r,
                           const small::V3& root) const;

  const RegionModel* model_;
  FreeBodies bodies_;
  std::vector<ConstraintRow> rows_;
  RowMatrices matrices_;
  RowResponse response_;
  RowCompliance compliance_;
  VecX forces_;
  LimitRows for_forces_, for_impulses_;
};

}  // namespace hazumi
