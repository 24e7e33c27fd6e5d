#include "tests/support/free_figure.h"

#include <algorithm>
#include <utility>

#include "engine/region/forces/hinge_moment.h"

namespace hazumi::test {

FreeFigure::FreeFigure(const Figure& figure, const Vec3& base) : base_(base) {
  ModelRequest request;
  request.roles.assign(figure.num_joints() + kRootAngles, Role::kConstant);
  std::fill_n(request.roles.begin(), figure.num_joints(), Role::kFree);
  request.angles = VecX::Zero(figure.num_joints() + kRootAngles);
  still_.angles.resize(figure.num_joints() + kRootAngles);
  for (RegionModel& model : CompileRegionModels(figure, request)) {
    islands_.emplace_back(std::move(model));
  }
}

FreeFigure::Island::Island(RegionModel of)
    : model(std::move(of)),
      layout(model, /*balls=*/false),
      kinematics(model),
      equations(model),
      q(layout.num_hinges()),
      qd(q.size()),
      tau(q.size()),
      x(q.size()) {}

void FreeFigure::Accelerate(const VecX& q, const VecX& qd, const VecX& tau, VecX* qdd) {
  for (Island& island : islands_) island.Accelerate(still_, base_, q, qd, tau, qdd);
}

void FreeFigure::Island::Accelerate(const DrivenMotion& still, const small::V3& base,
                                    const VecX& all_q, const VecX& all_qd, const VecX& all_tau,
                                    VecX* qdd) {
  for (int i = 0; i < layout.num_hinges(); ++i) {
    const Coordinate c = layout.hinges()[i].coordinate;
    q[i] = all_q[c];
    qd[i] = all_qd[c];
    tau[i] = all_tau[c];
  }
  kinematics.Move(layout, still, 0.0, q.data(), qd.data(), 0, kinematics.size());
  kinematics.SetOwnForces(base);
  for (int i = 0; i < kinematics.size(); ++i) {
    const RegionLayout::Node& node = layout.node(i);
    if (node.num_dofs == 0) continue;
    kinematics.AddJointMoment(
        i, MomentOfHinges(kinematics.motion()[i], node.num_dofs, tau.data() + node.dof));
  }
  equations.Solve(layout, kinematics.motion(), x.data());
  for (int i = 0; i < layout.num_hinges(); ++i) (*qdd)[layout.hinges()[i].coordinate] = x[i];
}

}  // namespace hazumi::test
