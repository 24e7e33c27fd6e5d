#include "engine/bake/walk/loose_balls.h"

#include <algorithm>
#include <optional>
#include <variant>

namespace hazumi {

namespace {

LooseBall BallOf(const HeldObject& object, int index) {
  const double radius = std::get<SphereShape>(object.shape).radius;
  const RigidInertia body = SolidSphere(Vec3::Zero(), radius, object.mass);
  return {body.mass, body.I_com(0, 0), index};
}

}  // namespace

void AppendTiesForBalls(const Figure& figure, const std::function<bool(JointIndex)>& touches,
                        std::vector<ModelRequest::Tie>* ties) {
  const auto first = std::find_if(figure.links().begin(), figure.links().end(),
                                  [&](const Link& link) { return touches(link.joint); });
  if (first == figure.links().end()) return;
  for (const Link& link : figure.links()) ties->push_back({first->joint, link.joint});
}

void AddBalls(const std::vector<HeldObject>& objects, const std::vector<LooseObject>& balls,
              const Figure& figure, const std::function<bool(JointIndex)>& touches,
              RegionModel* model) {
  const auto is_moved = [&](const Link& link) {
    const NodeJoint* seat = touches(link.joint) ? model->SeatOf(link.joint) : nullptr;
    return seat && model->nodes[seat->node].is_dynamic;
  };
  if (std::none_of(figure.links().begin(), figure.links().end(), is_moved)) return;
  for (const LooseObject& ball : balls) {
    model->balls.push_back(BallOf(objects[ball.object], ball.object));
  }
}

EnergyAccount::Stored EnergyOfBalls(const std::vector<HeldObject>& objects,
                                    const std::vector<LooseObject>& balls,
                                    const std::vector<LooseObject>& others, double gravity) {
  EnergyAccount::Stored sum;
  for (const LooseObject& ball : balls) {
    const auto is_that = [&](const LooseObject& other) { return other.object == ball.object; };
    if (std::any_of(others.begin(), others.end(), is_that)) continue;
    const LooseBall body = BallOf(objects[ball.object], ball.object);
    sum.kinetic += body.KineticEnergy(ball.motion);
    sum.potential += body.PotentialEnergy(ball.motion, gravity);
  }
  return sum;
}

}  // namespace hazumi
