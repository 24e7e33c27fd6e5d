#include "engine/bake/pose/object_flight.h"

namespace hazumi {

RigidInertia InertiaOf(const HeldObject& object) {
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    return SolidSphere(object.offset, sphere->radius, object.mass);
  }
  return SolidBox(object.offset, std::get<BoxShape>(object.shape).half_size, object.mass);
}

ObjectFlight::ObjectFlight(const Figure& figure, const HeldObject& object, double gravity)
    : holder_(figure.group(object.holder).last()), offset_(object.offset), gravity_(gravity) {}

void ObjectFlight::Release(const DynamicsWorkspace& ws, double seconds) {
  const BodyScratch& body = ws.body(holder_);
  const Vec3 arm = body.R * offset_;
  flight_ = Flight{seconds, {body.R, body.p + arm}, body.v + body.w.cross(arm), body.w};
}

ObjectPose ObjectFlight::At(const DynamicsWorkspace& ws, double seconds) const {
  if (!flight_) {
    const BodyScratch& body = ws.body(holder_);
    return {{body.R, body.p + body.R * offset_}, true};
  }
  const double t = seconds - flight_->start;
  const Vec3 p = flight_->X_WO.p + flight_->v * t + Vec3(0.0, 0.0, -0.5 * gravity_ * t * t);
  const double turn = flight_->w.norm() * t;
  if (turn == 0.0) return {{flight_->X_WO.R, p}, false};
  const Mat3 R = Eigen::AngleAxisd(turn, flight_->w.normalized()).toRotationMatrix();
  return {{R * flight_->X_WO.R, p}, false};
}

}  // namespace hazumi
