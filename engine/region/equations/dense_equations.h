#pragma once

#include "engine/region/node_motion.h"
#include "engine/region/region_model.h"

namespace hazumi {

// M x = T - b for free directions or hinges of an island.
struct IslandEquations {
  MatX M;
  VecX b;
};

// The equations of motion of a model with their matrix, which takes n^3 to solve. A root that
// answers the free joints is eliminated: in flight by the momentum that nothing changes, on a pin
// by what keeps the pin still.
class DenseEquations {
 public:
  explicit DenseEquations(const RegionModel& model);

  // M (k x k) and b (k) of the layout's dofs, the first k of what is kept, for nodes that move and
  // ask for forces as in `motion`, which is summed up towards the root on the way.
  void Assemble(const RegionLayout& layout, std::vector<NodeMotion>* motion);
  const IslandEquations& equations() const { return equations_; }
  // After it: x = -M^-1 b. A direction that moves no mass gets 0.
  void Solve(const RegionLayout& layout, double* x);
  // After Solve, with M = L L^T: X := L^-1 X and x := L^-T x.
  void SolveLower(const RegionLayout& layout, Eigen::Ref<MatX> X) const;
  void SolveUpper(const RegionLayout& layout, Eigen::Ref<VecX> x) const;

  // After Assemble: adds to `row` (by dof) what x does to the acceleration along n of a point p of
  // a node, from the root's origin; or, where it `turns`, to its angular acceleration about n. What
  // the root answers is left out.
  void AddToRow(const RegionLayout& layout, const std::vector<NodeMotion>& motion, int node,
                const small::V3& p, const small::V3& n, bool turns, Eigen::Ref<VecX> row) const;
  // Adds that to all rows at once: `along`, by row, is how its points move with the root, the one
  // end less the other.
  void AddRootToRows(const RegionLayout& layout, const Eigen::Matrix3Xd& along,
                     Eigen::Ref<MatX> rows) const;
  // In flight, after Assemble: the root's acceleration, less gravity's, where x is that of the
  // dofs.
  Vec3 RootAcceleration(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                        const double* x) const;

  // After Assemble: the impulse on the dofs [N m s] when the root's velocity jumps so that a pin,
  // which moved with v_pin [m/s], stands still. [METHOD 5.7]
  void PinImpulse(const Vec3& v_pin, VecX* impulse) const;

 private:
  void MakeRoom();
  void AssembleColumn(const RegionLayout& layout, const std::vector<NodeMotion>& motion, int node,
                      int dof, const small::V3& axis);
  void PassToParent(int node, std::vector<NodeMotion>* motion) const;
  void EliminateFlight(const RegionLayout& layout, const std::vector<NodeMotion>& motion);
  void EliminatePin(const RegionLayout& layout, const std::vector<NodeMotion>& motion);

  struct Node {
    int parent;  // -1 where nothing dynamic carries it
    bool is_dynamic;
  };
  std::vector<Node> nodes_;
  std::vector<int> to_pin_;  // nodes from the pin's to the root
  Vec3 p_pin_;
  bool root_answers_, is_pinned_;
  double mass_;
  int num_free_;
  IslandEquations equations_;
  MatX L_;
  Eigen::Matrix3Xd F_, J_;  // force on the root and motion of the pin for unit accelerations
  Eigen::MatrixX3d F_across_, J_across_;
};

}  // namespace hazumi
