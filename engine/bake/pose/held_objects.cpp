// Held by a joint whose body is at X_WB: X_WO = X_WB X_BO with X_BO = (rotation, offset).

#include "engine/bake/pose/held_objects.h"

#include <algorithm>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

// The holder's axes are not multiplied by 1, which would lose the sign of zeros.
Pose InHand(const BodyScratch& body, const Holder& holder) {
  const bool is_turned = !holder.rotation.isIdentity(0.0);
  return {is_turned ? Mat3(body.R * holder.rotation) : body.R, body.p + body.R * holder.offset};
}

}  // namespace

RigidInertia InertiaOf(const HeldObject& object, const Holder& holder) {
  HAZUMI_ASSERT(object.mass >= 0.0);
  HAZUMI_ASSERT(IsRotation(holder.rotation));
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    return SolidSphere(holder.offset, sphere->radius, object.mass);
  }
  const Vec3& half_size = std::get<BoxShape>(object.shape).half_size;
  return SolidBox(holder.offset, half_size, object.mass, holder.rotation);
}

Figure WithObject(const Figure& figure, const HeldObject& object, int holder) {
  HAZUMI_ASSERT(holder < static_cast<int>(object.holders.size()));
  if (holder < 0) return figure;
  const Holder& by = object.holders[holder];
  return figure.WithLoad(figure.group(by.joint).last(), InertiaOf(object, by));
}

HeldObjects::HeldObjects(const Animation& animation)
    : animation_(animation),
      states_(animation.held_objects.size()),
      flights_(animation.held_objects.size()) {
  ResetCurves();
}

void HeldObjects::ResetCurves() {
  curves_.clear();
  for (const HeldObject& object : animation_.held_objects) {
    const auto track = [&](int axis) {
      return CurveTrack(&object.keys[axis], animation_.rate, 0.0, {});
    };
    curves_.push_back({track(0), track(1), track(2)});
  }
}

int HolderAtFirst(const HeldObject& object, int first_frame) {
  const auto begins_later = [&](const Holder& holder) { return holder.first_frame > first_frame; };
  const auto later = std::find_if(object.holders.begin(), object.holders.end(), begins_later);
  if (later == object.holders.begin()) return -1;
  const Holder& last = *std::prev(later);
  const bool has_let_go = last.last_frame && *last.last_frame < first_frame;
  return has_let_go ? -1 : static_cast<int>(std::prev(later) - object.holders.begin());
}

std::vector<ObjectState> HeldObjects::AtFirst() const {
  std::vector<ObjectState> states;
  for (const HeldObject& object : animation_.held_objects) {
    states.push_back({HolderAtFirst(object, animation_.first_frame), std::nullopt});
  }
  return states;
}

void HeldObjects::Release(size_t object, int by, double seconds, const DynamicsWorkspace& ws) {
  ObjectState& state = states_[object];
  const Holder& holder = animation_.held_objects[object].holders[by];
  const BodyScratch& body = ws.body(animation_.figure->group(holder.joint).last());
  const Vec3 arm = body.R * holder.offset;
  state.flight =
      ObjectState::Flight{seconds, {InHand(body, holder), body.v + body.w.cross(arm), body.w}};
  state.holder = -1;
}

BodyMotion HeldObjects::InFlight(size_t object, double seconds) {
  const HeldObject& of = animation_.held_objects[object];
  const ObjectState::Flight& flight = *states_[object].flight;
  if (!of.touches_scene || animation_.scene.empty()) {
    return Falling(flight.from, seconds - flight.start, animation_.gravity);
  }
  std::optional<ObjectFlight>& way = flights_[object];
  if (!way || way->start() != flight.start || way->from() != flight.from) {
    way.emplace(of, animation_.scene, animation_.gravity, flight.start, flight.from,
                animation_.solver.rules());
  }
  return way->At(seconds);
}

std::optional<double> HeldObjects::StuckFrom(size_t object) const {
  const bool flies = states_[object].holder < 0 && flights_[object];
  return flies ? flights_[object]->stuck_from() : std::nullopt;
}

Figure HeldObjects::LoadedFigure() const {
  Figure figure = *animation_.figure;
  for (size_t i = 0; i < states_.size(); ++i) {
    figure = WithObject(figure, animation_.held_objects[i], states_[i].holder);
  }
  return figure;
}

std::vector<LooseObject> HeldObjects::LooseAt(double frame) {
  std::vector<LooseObject> loose;
  const double seconds = animation_.rate.SecondsAt(frame);
  for (size_t i = 0; i < states_.size(); ++i) {
    const HeldObject& of = animation_.held_objects[i];
    if (states_[i].holder >= 0 || !states_[i].flight || !of.touches_scene) continue;
    if (KeyAfterFlight(i) != of.keys[0].end()) continue;
    const BodyMotion motion = InFlight(i, seconds);
    if (!StuckFrom(i)) loose.push_back({static_cast<int>(i), motion});
  }
  return loose;
}

void HeldObjects::LetFly(const LooseObject& loose, double seconds) {
  ObjectState& state = states_[loose.object];
  if (state.holder < 0) state.flight = ObjectState::Flight{seconds, loose.motion};
}

// Keys before it was let go say nothing of what follows.
Keys::const_iterator HeldObjects::KeyAfterFlight(size_t object) const {
  const Keys& keys = animation_.held_objects[object].keys[0];
  return std::find_if(keys.begin(), keys.end(), [&](const Key& key) {
    return animation_.rate.SecondsAt(key.frame) >= states_[object].flight->start;
  });
}

ObjectPose HeldObjects::At(size_t object, const FigureMotion& motion, const DynamicsWorkspace& ws) {
  const ObjectState& state = states_[object];
  const HeldObject& of = animation_.held_objects[object];
  if (state.holder >= 0) {
    const Holder& holder = of.holders[state.holder];
    const BodyScratch& body = ws.body(animation_.figure->group(holder.joint).last());
    return {InHand(body, holder), state.holder};
  }
  for (const LooseObject& loose : motion.loose) {
    if (loose.object == static_cast<int>(object)) return {loose.motion.X_WB, -1};
  }
  if (state.flight) {
    const auto next = KeyAfterFlight(object);
    const bool is_keyed = next != of.keys[0].end() && next->frame <= motion.frame;
    const double seconds = animation_.rate.SecondsAt(motion.frame);
    if (!is_keyed) return {InFlight(object, seconds).X_WB, -1};
  }
  Pose X_WO;
  for (int axis = 0; axis < 3; ++axis) X_WO.p[axis] = curves_[object][axis].At(motion.frame).value;
  return {X_WO, -1};
}

}  // namespace hazumi
