#include "engine/analysis/frame_dynamics.h"

#include <algorithm>

#include "engine/bake/pose/held_objects.h"

namespace hazumi {

namespace {

// Every fourth number from `at` on.
void PutVector(const Vec3& x, double* at) {
  for (int i = 0; i < 3; ++i) at[4 * i] = x[i];
}
Vec3 VectorAt(const double* at) { return {at[0], at[4], at[8]}; }

void PutInertia(const RigidInertia& body, double* at) {
  at[4 * InertiaField::kMass] = body.mass;
  PutVector(body.com, at + 4 * InertiaField::kCom);
  PutVector(body.I_com.diagonal(), at + 4 * InertiaField::kInertia);
  PutVector({body.I_com(1, 2), body.I_com(2, 0), body.I_com(0, 1)},
            at + 4 * (InertiaField::kInertia + 3));
}

bool AreHeldAlike(const std::vector<ObjectPose>& a, const std::vector<ObjectPose>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ObjectPose& x, const ObjectPose& y) { return x.holder == y.holder; });
}

Figure With(const Animation& animation, const std::vector<ObjectPose>& objects) {
  Figure figure = *animation.figure;
  for (size_t i = 0; i < objects.size(); ++i) {
    figure = WithObject(figure, animation.held_objects[i], objects[i].holder);
  }
  return figure;
}

}  // namespace

FrameDynamics::FrameDynamics(const Animation& animation, const PlacedFrames& placed,
                             const EffortKernels& kernels)
    : animation_(animation), placed_(placed), kernels_(kernels) {
  const size_t joints = placed.hinges().size(), bodies = joints + 1;
  inertias_ = LaneArray(4 * InertiaField::kNumFields * bodies);
  motions_ = LaneArray(4 * kMotionFields * bodies);
  loads_ = LaneArray(4 * kLoadFields * bodies);
  needs_ = LaneArray(4 * kLoadFields);
  torques_ = LaneArray(4 * joints);
  four_.hinges = placed.hinges().data();
  four_.num_hinges = static_cast<int>(joints);
  four_.inertias = inertias_.data();
  four_.motions = motions_.data();
  four_.loads = loads_.data();
  four_.needed = needs_.data();
  four_.torques = torques_.data();
}

void FrameDynamics::Load(size_t lane, const MotionFrame& frame) {
  if (!latest_ || !AreHeldAlike(latest_->objects, frame.objects)) {
    latest_ = std::make_shared<Loaded>(Loaded{frame.objects, With(animation_, frame.objects)});
  }
  loaded_[lane] = latest_;
  const Figure& figure = latest_->figure;
  PutInertia(figure.root_body(), inertias_.data() + lane);
  for (int j = 0; j < figure.num_joints(); ++j) {
    PutInertia(figure.body(JointIndex(j)),
               inertias_.data() + 4 * InertiaField::kNumFields * (j + 1) + lane);
  }
}

void FrameDynamics::Set(size_t lane, const MotionFrame& frame, const MovedFrame& at) {
  if (!loaded_[lane] || !AreHeldAlike(loaded_[lane]->objects, frame.objects)) Load(lane, frame);
  four_.rates[lane] = at.qd;
  four_.accelerations[lane] = at.qdd;
  double* root = motions_.data() + lane;
  PutVector(at.root.w, root);
  PutVector(at.root.alpha, root + 12);
  PutVector(at.root.a + animation_.gravity * Vec3::UnitZ(), root + 24);
}

void FrameDynamics::Demand(size_t first_frame) {
  four_.placed = placed_.FourWith(first_frame);
  kernels_.demand(four_);
  for (size_t lane = 0; lane < 4; ++lane) {
    needed_[lane] = {VectorAt(four_.needed + lane), VectorAt(four_.needed + 12 + lane)};
    p_root_[lane] = placed_[first_frame + lane].p(JointIndex());
  }
}

void FrameDynamics::Push(size_t lane, JointIndex joint, const Vec3& p, const Wrench& push) {
  Wrench& needed = needed_[lane];
  needed.force -= push.force;
  needed.moment -= push.moment + (p - p_root_[lane]).cross(push.force);
  if (!joint.is_valid()) return;
  const size_t body = static_cast<size_t>(joint.value()) + 1;
  const Vec3 from = VectorAt(four_.placed + 4 * (kPlacedFields * body + 9) + lane);
  double* load = four_.loads + 4 * kLoadFields * body + lane;
  PutVector(VectorAt(load) - push.force, load);
  PutVector(VectorAt(load + 12) - push.moment - (p - from).cross(push.force), load + 12);
}

void FrameDynamics::FindTorques() { kernels_.relay(four_); }

VecX FrameDynamics::torques(size_t lane) const {
  VecX found(four_.num_hinges);
  for (int j = 0; j < four_.num_hinges; ++j) found[j] = four_.torques[4 * j + lane];
  return found;
}

}  // namespace hazumi
