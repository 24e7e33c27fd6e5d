#include "tests/support/animations.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/dynamics/kinematics.h"

namespace hazumi::test {

Animation Still(Figure figure) {
  Animation animation;
  animation.joint_keys.resize(figure.num_joints());
  animation.figure = std::make_shared<const Figure>(std::move(figure));
  animation.last_frame = 30;
  return animation;
}

JointIndex JointOf(const Animation& animation, const char* name) {
  const auto joint = animation.figure->FindJoint(name);
  if (joint) return *joint;
  return animation.figure->group(GroupOf(animation, name)).first;
}

GroupIndex GroupOf(const Animation& animation, const char* name) {
  return animation.figure->FindGroup(name).value();
}

Keys& KeysOf(Animation* animation, const char* joint) {
  return animation->joint_keys[JointOf(*animation, joint).value()];
}

void KeyTheRest(Animation* animation) {
  const double first = animation->first_frame, last = animation->last_frame;
  const auto complete = [&](double rest, Keys* keys) {
    if (keys->empty()) *keys = {{first, rest, {}, Interpolation::kCubic}};
    if (keys->back().frame == last) return;
    keys->push_back({last, keys->back().value, {}, Interpolation::kCubic});
  };
  for (size_t j = 0; j < animation->joint_keys.size(); ++j) {
    complete(animation->figure->joints()[j].rest, &animation->joint_keys[j]);
  }
  for (Keys& keys : animation->root_keys) complete(0.0, &keys);
}

DynamicsRegion& AddRegion(Animation* animation, const char* name, int first, int last,
                          const std::vector<const char*>& joints, double friction) {
  DynamicsRegion region;
  region.name = name;
  region.first_frame = first;
  region.last_frame = last;
  for (const char* joint : joints) {
    const JointIndex j = JointOf(*animation, joint);
    const int end = animation->figure->joint(j).subtree_end.value();
    for (int k = j.value(); k < end; ++k) region.joints.emplace_back(k);
  }
  std::sort(region.joints.begin(), region.joints.end());
  region.friction.assign(region.joints.size(), friction);
  animation->regions.push_back(region);
  return animation->regions.back();
}

PlacementSpan& AddPin(Animation* animation, int first, int last, const char* joint) {
  animation->placements.push_back(
      {PlacementKind::kPinned, first, last, GroupOf(*animation, joint), {}});
  return animation->placements.back();
}

PlacementSpan& AddGravity(Animation* animation, int first, int last) {
  animation->placements.push_back({PlacementKind::kGravity, first, last, {}, {}});
  return animation->placements.back();
}

IkHold& AddHold(Animation* animation, int first, int last, const char* joint, bool orientation) {
  animation->holds.push_back(
      {GroupOf(*animation, joint), first, last, orientation, HoldReach::kLimb});
  return animation->holds.back();
}

void AddFloor(Animation* animation, double height) {
  animation->scene.push_back({"floor", Plane{Vec3::UnitZ(), height}, ""});
}

Motion BakeOrFail(const Animation& animation, const BakeOptions& options) {
  Result<Motion> motion = Bake(animation, options);
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return motion.ok() ? std::move(motion).value() : Motion();
}

Error BakeError(const Animation& animation) {
  const Result<Motion> motion = Bake(animation);
  EXPECT_FALSE(motion.ok());
  return motion.ok() ? Error() : motion.error();
}

Vec3 OriginOf(const Animation& animation, const MotionFrame& frame, const char* joint) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  return ws.body(JointOf(animation, joint)).p;
}

Vec3 VelocityOf(const Animation& animation, const MotionFrame& frame, const MotionLimit& rates,
                const char* joint) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  ComputeVelocities(*animation.figure, rates.root_w, rates.root_v, rates.qd, &ws);
  return ws.body(JointOf(animation, joint)).v;
}

std::vector<MotionEvent> EventsOf(const Motion& motion, EventKind kind) {
  std::vector<MotionEvent> events;
  std::copy_if(motion.events.begin(), motion.events.end(), std::back_inserter(events),
               [kind](const MotionEvent& event) { return event.kind == kind; });
  return events;
}

namespace {

bool IsSame(const Pose& a, const Pose& b) { return a.R == b.R && a.p == b.p; }

bool IsSame(const MotionLimit& a, const MotionLimit& b) {
  return a.q == b.q && a.qd == b.qd && IsSame(a.X_WR, b.X_WR) && a.root_w == b.root_w &&
         a.root_v == b.root_v;
}

}  // namespace

bool IsSame(const MotionFrame& a, const MotionFrame& b) {
  const auto same_object = [](const ObjectPose& x, const ObjectPose& y) {
    return IsSame(x.X_WO, y.X_WO) && x.holder == y.holder;
  };
  return a.q == b.q && IsSame(a.X_WR, b.X_WR) && IsSame(a.before, b.before) &&
         IsSame(a.after, b.after) && a.com == b.com && a.pinned == b.pinned &&
         a.constraint_forces == b.constraint_forces && a.contacts == b.contacts &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    same_object);
}

}  // namespace hazumi::test
