// A node N of the model of all free joints moves as the last joint J of its hinges does, at R_NJ,
// p_NJ in its frame:
//   R_N = R_J R_NJ^T,   p_N = p_J - R_N p_NJ,   w_N = w_J,   v_N = v_J - w_J x R_N p_NJ.

#include "engine/analysis/outer_pushes.h"

#include "engine/bake/walk/outer_forces.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi {

namespace {

RegionModel ModelOf(const Figure& figure) {
  ModelRequest request;
  const size_t coordinates = static_cast<size_t>(figure.num_joints()) + kRootAngles;
  request.roles.assign(coordinates, Role::kFree);
  request.angles = VecX::Zero(static_cast<Eigen::Index>(coordinates));
  request.coupling = RootCoupling::kFlight;
  request.lists_joints = true;
  return CompileRegionModels(figure, request).front();
}

}  // namespace

OuterPushes::OuterPushes(const Animation& animation)
    : animation_(animation),
      model_(ModelOf(*animation.figure)),
      layout_(model_, /*balls=*/false),
      kinematics_(model_),
      places_(model_.nodes.size()),
      joint_of_(model_.nodes.size()),
      ws_(*animation.figure) {
  for (const NodeJoint& seat : model_.joints) joint_of_[seat.node] = seat.joint;
}

void OuterPushes::Place(const MovedFrame& at) {
  const Figure& figure = *animation_.figure;
  const VecX q = Eigen::Map<const VecX>(at.q, figure.num_joints());
  const VecX qd = Eigen::Map<const VecX>(at.qd, figure.num_joints());
  ComputePositions(figure, *at.X_WR, q, &ws_);
  ComputeVelocities(figure, at.root.w, at.root.v, qd, &ws_);
  for (const NodeJoint& seat : model_.joints) {
    const BodyScratch& body = ws_.body(seat.joint);
    const Mat3 R = body.R * seat.R_NJ.transpose();
    const Vec3 r = R * seat.p_N;
    NodeMotion& node = kinematics_.motion()[seat.node];
    node.R = small::ToSmall(R);
    node.w = small::V3(body.w);
    node.p = small::V3(body.p - r - at.X_WR->p);
    places_[seat.node] = {small::V3(body.p - r), small::V3(body.v - body.w.cross(r))};
  }
}

const std::vector<OuterPush>& OuterPushes::At(double t, const MovedFrame& at,
                                              const Figure& loaded) {
  found_.clear();
  std::vector<ForceSpec> specs;
  AddOuterForces(animation_, loaded, t, model_, &specs);
  if (specs.empty()) return found_;
  Place(at);
  kinematics_.ClearForces();
  const DrivenMotion none;
  const RegionState state = {t, model_, layout_, none, kinematics_, nullptr, nullptr, places_};
  for (const auto& law : MakeLaws(specs)) law->AddForces(state, &kinematics_);
  for (size_t i = 0; i < places_.size(); ++i) {
    const NodeMotion& node = kinematics_.motion()[i];
    const Wrench push = {-node.f.eigen(), -node.n.eigen()};  // a node asks for what it lacks
    if (push.force.isZero(0.0) && push.moment.isZero(0.0)) continue;
    found_.push_back({joint_of_[i], places_[i].p.eigen(), push});
  }
  return found_;
}

}  // namespace hazumi
