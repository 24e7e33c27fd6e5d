// An impulse P at a point of a figure at rest, that nothing else acts on, does what a force P would
// do to its accelerations:
//   M dv = J^T P,   in flight  dv_com = P / m
// with M the inertia of the free joints, what the root answers included, J the point's Jacobian.
// Limits answer when the motion goes on, as they do to any rate that leads out.

#include "engine/bake/walk/outer_forces.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "engine/region/region_dynamics.h"

namespace hazumi {

namespace {

// Null: the island does not carry it.
const NodeJoint* CarriedSeat(JointIndex joint, const RegionModel& model) {
  const NodeJoint* seat = model.SeatOf(joint);
  return seat && model.nodes[seat->node].is_dynamic ? seat : nullptr;
}

std::span<const Link> LinksOf(JointIndex joint, const Figure& figure) {
  const std::vector<Link>& links = figure.links();
  const auto first =
      std::lower_bound(links.begin(), links.end(), joint,
                       [](const Link& link, JointIndex j) { return link.joint < j; });
  const auto last = std::upper_bound(first, links.end(), joint,
                                     [](JointIndex j, const Link& link) { return j < link.joint; });
  return {first, last};
}

// In the frame of the node.
LinkSurface OnNode(const NodeJoint& seat, LinkSurface surface) {
  surface.center = hazumi::OnNode(seat, surface.center);
  surface.normal = seat.R_NJ * surface.normal;
  return surface;
}

void AddForce(const WindForce& wind, const Figure& figure, const RegionModel& model,
              std::vector<ForceSpec>* forces) {
  WindSpec spec{wind.velocity, wind.density, {}, {}};
  for (const NodeJoint& seat : model.joints) {
    if (!model.nodes[seat.node].is_dynamic) continue;
    for (const Link& link : LinksOf(seat.joint, figure)) {
      if (link.surface) {
        spec.surfaces.push_back({seat.node, OnNode(seat, *link.surface)});
        continue;
      }
      const Capsule& capsule = link.capsule;
      spec.cylinders.push_back({seat.node, hazumi::OnNode(seat, capsule.a),
                                hazumi::OnNode(seat, capsule.b), 2.0 * capsule.radius});
    }
  }
  if (!spec.cylinders.empty() || !spec.surfaces.empty()) forces->emplace_back(std::move(spec));
}

void AddForce(const AttractForce& pull, const Figure& figure, const RegionModel& model,
              std::vector<ForceSpec>* forces) {
  const JointIndex joint = pull.at.joint ? figure.group(*pull.at.joint).last() : JointIndex();
  const NodeJoint* seat = CarriedSeat(joint, model);
  if (!seat) return;
  forces->emplace_back(AttractionSpec{seat->node, hazumi::OnNode(*seat, pull.at.offset), pull.to,
                                      pull.force, pull.radius});
}

// As large as an impulse.
class ForceAtPoint : public ForceLaw {
 public:
  ForceAtPoint(int node, const Vec3& point, const Vec3& force)
      : node_(node), point_(point), force_(force) {}
  std::string_view name() const override { return "push"; }
  void AddForces(const RegionState&, NodeKinematics* kinematics) const override {
    const small::V3 r = kinematics->motion()[node_].R * small::V3(point_);
    kinematics->AddForce(node_, r, small::V3(force_));
  }

 private:
  int node_;
  Vec3 point_, force_;
};

// By free hinge of the model, in its order.
std::vector<Coordinate> FreeHingesOf(const RegionLayout& layout) {
  std::vector<Coordinate> hinges;
  for (const FreeHinge& hinge : layout.hinges()) hinges.push_back(hinge.coordinate);
  return hinges;
}

void PushIsland(const RegionModel& model, std::shared_ptr<const ForceLaw> push,
                RotationState* state) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  RegionDynamics dynamics(model, {std::move(push)}, /*gravity=*/0.0);
  const DrivenMotion still;
  dynamics.SetDriven(&still, 0.0, 1.0);
  const RegionLayout& layout = dynamics.layout();
  const std::vector<Coordinate> hinges = FreeHingesOf(layout);
  VecX q(layout.num_hinges()), qd(q.size());
  for (size_t i = 0; i < hinges.size(); ++i) {
    q[static_cast<long>(i)] = state->q[hinges[i]];
    qd[static_cast<long>(i)] = state->qd[hinges[i]];
  }
  VecX y(layout.state_size()), at_rest(y.size()), jump(y.size());
  layout.Pack(q, qd, y.data());
  layout.Pack(q, VecX::Zero(q.size()), at_rest.data());
  dynamics.Derivative(0.0, at_rest.data(), jump.data());
  y.tail(layout.num_dofs()) += jump.tail(layout.num_dofs());
  const VecX none = VecX::Constant(q.size(), kInfinity);
  layout.Unpack(y.data(), -none, none, &q, &qd);
  for (size_t i = 0; i < hinges.size(); ++i) state->qd[hinges[i]] = qd[static_cast<long>(i)];
}

// Acts at one instant, and not in between.
void AddForce(const PushForce&, const Figure&, const RegionModel&, std::vector<ForceSpec>*) {}

// Disables the fading of the lift of plates next to 0 and 90 degrees, where the lift is 0.
void LiftPlates(std::vector<ForceSpec>* forces) {
  for (ForceSpec& force : *forces) {
    auto* const wind = std::get_if<WindSpec>(&force);
    if (!wind) continue;
    for (AirSurface& own : wind->surfaces) {
      own.surface.is_faded = own.surface.kind != LinkSurface::Kind::kPlate;
    }
  }
}

}  // namespace

void AddOuterForces(const Animation& animation, const Figure& figure, double t,
                    const RegionModel& model, std::vector<ForceSpec>* forces) {
  if (animation.forces.empty()) return;
  const double frame = animation.rate.FrameAt(t);
  for (const OuterForce& force : animation.forces) {
    if (frame < force.first_frame || frame >= force.last_frame) continue;
    std::visit([&](const auto& action) { AddForce(action, figure, model, forces); }, force.action);
  }
  if (animation.solver.rules().lifts_plates_at_all_angles) LiftPlates(forces);
}

bool Push(const PushForce& push, const Figure& figure, ModelRequest request, RotationState* state) {
  const JointIndex joint = push.at.joint ? figure.group(*push.at.joint).last() : JointIndex();
  request.lists_joints = true;
  bool is_felt = request.coupling == RootCoupling::kFlight;
  for (const RegionModel& model : CompileRegionModels(figure, request)) {
    const NodeJoint* seat = CarriedSeat(joint, model);
    if (!seat) continue;
    const Vec3 point = hazumi::OnNode(*seat, push.at.offset);
    PushIsland(model, std::make_shared<ForceAtPoint>(seat->node, point, push.impulse), state);
    is_felt = true;
  }
  if (request.coupling == RootCoupling::kFlight) {
    state->anchor.v += push.impulse / figure.total_mass();
  }
  return is_felt;
}

}  // namespace hazumi
