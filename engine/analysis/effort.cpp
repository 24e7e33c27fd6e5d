// Quantities of each frame, in world axes:
//   tau, F, N   inverse dynamics of the whole figure and the objects that it holds, with the root
//               as base: the torques of the hinges, and the force and moment required on the root
//               at p_R. The known external forces are subtracted from F, N: constraint forces,
//               contact forces of regions (MotionFrame::contacts), wind and pulls.
//   f_k         contact forces at the points p_k that touch or grip (supports.h). Their wrench is
//               the nearest to F, N about the centre of mass (contact_forces.cpp).
//   tau_i      -= axis_i . (p_k - p_i) x f_k   for each hinge i between the root and k
//               (principle of virtual work), and likewise for the known forces.
// The remainder of F, N is the residual wrench.

#include "engine/analysis/effort.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/frame_dynamics.h"
#include "engine/analysis/outer_pushes.h"
#include "engine/analysis/placed_frames.h"
#include "engine/analysis/smooth_motion.h"
#include "engine/analysis/supports.h"

namespace hazumi {

namespace {

class EffortWalk {
 public:
  EffortWalk(const Animation& animation, size_t num_frames, const EffortOptions& options,
             const TouchLimits& limits)
      : animation_(animation),
        options_(options),
        supports_(animation, num_frames, limits),
        placed_(*animation.figure, num_frames),
        dynamics_(animation, placed_) {
    if (!animation.forces.empty()) outer_.emplace(animation);
    for (const Joint& joint : animation.figure->joints()) {
      strengths_.push_back({joint.strength ? &*joint.strength : nullptr, joint.lower, joint.upper});
    }
    shares_ = least_ = LaneArray(4 * strengths_.size());
  }

  void Place(const MovedFrame& at) {
    if (const double* four = placed_.Add(*at.X_WR, at.q)) supports_.AddFour(four);
  }
  void Touch(double frame_time) {
    if (const double* four = placed_.Finish()) supports_.AddFour(four);
    supports_.Finish(frame_time);
  }

  // Of the next frames, four at most, in order.
  void Walk(const Motion& motion, size_t first, SmoothMotion* smooth, Effort* effort) {
    const size_t last = std::min(first + 4, motion.frames.size()) - 1;
    MovedFrame at[4];
    for (size_t lane = 0; lane < 4; ++lane) {
      const size_t i = std::min(first + lane, last);
      at[lane] = first + lane <= last ? smooth->At(i) : at[last - first];
      dynamics_.Set(lane, motion.frames[i], at[lane]);
    }
    dynamics_.Demand(first);
    for (size_t i = first; i <= last; ++i) {
      lane_ = i - first;
      const MotionFrame& frame = motion.frames[i];
      const double t = motion.rate.SecondsAt(frame.frame);
      TakeOffOuterForces(t, at[lane_]);
      const double at_frame = FrameAtRate(frame.frame, motion.rate, animation_.rate);
      Supply({i, frame, at_frame, placed_[i]}, &effort->frames[i]);
    }
    dynamics_.FindTorques();
    FindShares(at);
    for (size_t i = first; i <= last; ++i) {
      effort->frames[i].tau = dynamics_.torques(i - first);
      SetShares(i - first, &effort->frames[i]);
    }
  }

 private:
  void Supply(const SupportedFrame& at, FrameEffort* found) {
    TakeOffConstraints(at.frame, at.placed);
    TakeOffContacts(at.frame, found);
    supports_.PointsAt(at, &points_);
    const Vec3 root = at.placed.p(JointIndex()), from_com = root - at.frame.com;
    Wrench needed = dynamics_.needed(lane_);
    needed.moment += from_com.cross(needed.force);
    found->from_nowhere = solver_.Solve(needed, at.frame.com, points_, options_.friction, &forces_);
    found->from_nowhere.moment -= from_com.cross(found->from_nowhere.force);
    PushPoints();
    found->contacts.reserve(found->contacts.size() + points_.size());
    for (size_t i = 0; i < points_.size(); ++i) {
      const ContactPoint& point = points_[i];
      found->contacts.push_back({point.joint, point.is_grip, point.p, forces_[i]});
    }
  }

  // Those of one joint that follow each other together.
  void PushPoints() {
    for (size_t i = 0; i < points_.size();) {
      const ContactPoint& first = points_[i];
      Wrench push;
      for (; i < points_.size() && points_[i].joint == first.joint; ++i) {
        push.force += forces_[i];
        push.moment += (points_[i].p - first.p).cross(forces_[i]);
      }
      dynamics_.Push(lane_, first.joint, first.p, push);
    }
  }

  // What holds an end is the figure's own, or from outside.
  void TakeOffConstraints(const MotionFrame& frame, const PlacedFrame& placed) {
    for (size_t i = 0; i < frame.constraint_pushes.size(); ++i) {
      const Wrench& on_a = frame.constraint_pushes[i];
      const Constraint& constraint = animation_.constraints[i];
      TakeOff(constraint.a, on_a, placed);
      TakeOff(constraint.b, {-on_a.force, -on_a.moment}, placed);
    }
  }

  void TakeOffContacts(const MotionFrame& frame, FrameEffort* found) {
    for (const ContactPush& push : frame.contacts.pushes) {
      const JointIndex joint =
          push.link < 0 ? JointIndex() : animation_.figure->links()[push.link].joint;
      dynamics_.Push(lane_, joint, push.p, {push.force, Vec3::Zero()});
      found->contacts.push_back({joint, false, push.p, push.force});
    }
  }

  // Forces that end with the animation act in its last frame, which is known from the left.
  void TakeOffOuterForces(double t, const MovedFrame& at) {
    if (!outer_) return;
    constexpr double kBefore = 1e-6;  // [s]
    const double end = animation_.rate.SecondsAt(animation_.last_frame);
    for (const OuterPush& on :
         outer_->At(std::min(t, end - kBefore), at, dynamics_.figure(lane_))) {
      dynamics_.Push(lane_, on.joint, on.p, on.push);
    }
  }

  void TakeOff(const ConstraintEnd& end, const Wrench& push, const PlacedFrame& placed) {
    if (end.is_in_world) return;
    const Figure& figure = *animation_.figure;
    dynamics_.Push(lane_, HeldJoint(end, figure), HeldPlace(end, figure, placed), push);
  }

  void FindShares(const MovedFrame at[4]) {
    const double *angles[4], *rates[4];
    for (size_t lane = 0; lane < 4; ++lane) {
      angles[lane] = at[lane].q;
      rates[lane] = at[lane].qd;
    }
    kernels_.share(strengths_.data(), static_cast<int>(strengths_.size()), dynamics_.torques(),
                   angles, rates, shares_.data(), least_.data());
  }

  void SetShares(size_t lane, FrameEffort* found) const {
    found->share.resize(found->tau.size());
    for (size_t j = 0; j < strengths_.size(); ++j) {
      found->share[static_cast<Eigen::Index>(j)] = shares_.data()[4 * j + lane];
      if (least_.data()[4 * j + lane] != 0.0) found->least.emplace_back(static_cast<int>(j));
    }
  }

  const Animation& animation_;
  EffortOptions options_;
  Supports supports_;
  PlacedFrames placed_;
  std::optional<OuterPushes> outer_;
  FrameDynamics dynamics_;
  size_t lane_ = 0;  // of the four frames
  ContactForceSolver solver_;
  EffortKernels kernels_ = BestEffortKernels();
  std::vector<HingeStrength> strengths_;  // by joint
  LaneArray shares_, least_;              // by joint and frame
  std::vector<ContactPoint> points_;
  std::vector<Vec3> forces_;
};

// A capture's feet shake, and swing by low.
TouchLimits LimitsFor(bool is_capture) {
  TouchLimits limits;
  if (!is_capture) return limits;
  limits.clearance = 0.05;
  limits.drift = 0.1;
  limits.fastest = 0.6;
  return limits;
}

}  // namespace

bool IsCapture(const Animation& animation) {
  constexpr double kNearlyEvery = 0.8, kFewest = 8.0;  // share of the frames; frames
  const double frames = animation.last_frame - animation.first_frame + 1;
  if (frames < kFewest) return false;
  int keyed = 0, dense = 0;
  const auto count = [&](const Keys& keys) {
    keyed += keys.size() > 1;
    dense += static_cast<double>(keys.size()) >= kNearlyEvery * frames;
  };
  for (const Keys& keys : animation.joint_keys) count(keys);
  for (const Keys& keys : animation.root_keys) count(keys);
  return dense > 0 && 2 * dense >= keyed;
}

Effort EffortOf(const Animation& animation, const Motion& motion, const EffortOptions& options) {
  Effort effort;
  if (motion.frames.empty()) return effort;
  const bool is_capture = IsCapture(animation);
  SmoothMotion smooth(motion, animation.rate.SecondsAt(animation.last_frame));
  if (is_capture) effort.is_filtered = smooth.Filter(options.cutoff);
  if (effort.is_filtered) effort.cutoff = options.cutoff;
  EffortWalk walk(animation, motion.frames.size(), options, LimitsFor(is_capture));
  for (size_t i = 0; i < motion.frames.size(); ++i) walk.Place(smooth.At(i));
  walk.Touch(motion.rate.seconds_per_frame());
  effort.frames.resize(motion.frames.size());
  for (size_t first = 0; first < motion.frames.size(); first += 4) {
    walk.Walk(motion, first, &smooth, &effort);
  }
  return effort;
}

}  // namespace hazumi
