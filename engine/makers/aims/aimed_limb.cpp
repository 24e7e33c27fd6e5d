#include "engine/makers/aims/aimed_limb.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/bake/pose/held_objects.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/reach_pose.h"
#include "engine/makers/carried_body.h"
#include "engine/makers/throws/release_pose.h"
#include "engine/makers/throws/throw_poses.h"
#include "engine/solve/turn_vector.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr int kFrames = 60;  // of the model, about
constexpr int kMostPerFrame = 8;
constexpr int kIntervals = 5;  // of the splines, about
constexpr int kKeys = 10;      // of a torque, about

// Frames from the first one on, about so far apart, with each of `with` among them.
std::vector<int> FramesThrough(int first, const std::vector<int>& with, int apart) {
  std::vector<int> frames = {first};
  for (const int next : with) {
    const int from = frames.back();
    const int count = std::max(1, (2 * (next - from) + apart) / (2 * apart));
    for (int i = 1; i <= count; ++i) frames.push_back(from + (next - from) * i / count);
  }
  return frames;
}

// A cubic from value and rate to value and rate over a time of `h`, at a share s of it.
template <typename T>
T CubicAt(const T& p0, const T& v0, const T& p1, const T& v1, double h, double s) {
  const double s2 = s * s, s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * p0 + (s3 - 2.0 * s2 + s) * h * v0 +
         (3.0 * s2 - 2.0 * s3) * p1 + (s3 - s2) * h * v1;
}

// Whether gravity alone places the figure in a frame.
bool IsFalling(const MotionFrame& frame, const Animation& animation) {
  return !frame.pinned && std::any_of(animation.placements.begin(), animation.placements.end(),
                                      [&](const PlacementSpan& span) {
                                        return span.kind == PlacementKind::kGravity &&
                                               frame.frame >= span.first_frame &&
                                               frame.frame < span.last_frame;
                                      });
}

}  // namespace

AimedLimb::AimedLimb(AimedHinges hinges, const DynamicsRegion& region, std::vector<AimGoal> goals,
                     double most, const Animation& animation, const Motion& motion)
    : animation_(animation),
      figure_(*animation.figure),
      motion_(motion),
      hinges_(std::move(hinges)),
      goals_(std::move(goals)),
      first_(region.first_frame) {
  std::stable_sort(goals_.begin(), goals_.end(),
                   [](const AimGoal& a, const AimGoal& b) { return a.frame < b.frame; });
  last_ = goals_.back().frame;
  goes_on_ = last_ < region.last_frame;
  const int frames = last_ - first_;
  per_frame_ = std::clamp((kFrames + frames - 1) / frames, 1, kMostPerFrame);
  knots_ = FramesThrough(first_, GoalFrames(), std::max(1, (frames + kKeys / 2) / kKeys));
  BuildChain(region, most);
  AddFrames();
  TakeStrengths();
  TakePairs();
  AskForGoals();
}

std::vector<int> AimedLimb::GoalFrames() const {
  std::vector<int> frames;
  for (const AimGoal& goal : goals_) {
    if (frames.empty() || frames.back() != goal.frame) frames.push_back(goal.frame);
  }
  return frames;
}

void AimedLimb::BuildChain(const DynamicsRegion& region, double most) {
  solve::Chain& chain = problem_.chain;
  chain.step = animation_.rate.seconds_per_frame() / per_frame_;
  chain.gravity = {0.0, 0.0, -animation_.gravity};
  problem_.most = most;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    const JointIndex j = hinges_.path[k];
    const Joint& joint = figure_.joint(j);
    chain.joints.push_back({joint.X_PJ.p, {{joint.axis, false}}});
    solve::AimHinge hinge;
    hinge.before = joint.X_PJ.R;
    hinge.moves = hinges_.moves[k] != 0;
    const auto at = std::lower_bound(region.joints.begin(), region.joints.end(), j);
    if (hinge.moves) {
      hinge.friction =
          FrictionRate(region.friction[static_cast<size_t>(at - region.joints.begin())]);
    }
    hinge.is_bounded = joint.strength.has_value();
    hinge.lower = joint.lower;
    hinge.upper = joint.upper;
    const MotionLimit& start =
        motion_.frames[static_cast<size_t>(first_ - motion_.frames[0].frame)].after;
    hinge.start_rate = start.qd[j.value()];
    problem_.hinges.push_back(hinge);
  }
}

namespace {

// Geometric mean of both directions; none: not known.
std::optional<double> MeanStrength(const Joint& joint) {
  if (!joint.strength) return std::nullopt;
  return std::sqrt(joint.strength->positive.torque * joint.strength->negative.torque);
}

}  // namespace

// A hinge whose strength is not known is as strong as those that share its joint, or else turns
// what it carries as fast as arms can.
void AimedLimb::TakeStrengths() {
  constexpr double kFast = 300.0;  // [rad/s^2]
  constexpr double kLeast = 1e-6;  // [N m]
  const solve::ChainPose pose =
      solve::PoseOfChain(problem_.chain, 1, solve::TurnsOf(problem_, start_.col(1)));
  const std::vector<MatX> carried = solve::CarriedInertias(problem_.chain, 1, pose);
  std::vector<double> strengths;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    solve::AimHinge& hinge = problem_.hinges[k];
    const JointGroup& group = figure_.group(figure_.joint(hinges_.path[k]).group);
    double product = 1.0;
    int count = 0;
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      const std::optional<double> known = MeanStrength(figure_.joint(JointIndex(j)));
      if (known) product *= *known;
      count += known ? 1 : 0;
    }
    hinge.strength =
        count > 0 ? std::pow(product, 1.0 / count) : std::max(kFast * carried[k](0, 0), kLeast);
    hinge.strength = MeanStrength(figure_.joint(hinges_.path[k])).value_or(hinge.strength);
    if (hinge.moves) strengths.insert(strengths.end(), knots_.size(), hinge.strength);
  }
  strengths_ = Eigen::Map<const VecX>(strengths.data(), static_cast<int>(strengths.size()));
}

// Frame by frame of the model: the carrier, the angles, and what turns with each hinge.
void AimedLimb::AddFrames() {
  solve::Chain& chain = problem_.chain;
  const int n = static_cast<int>(hinges_.path.size());
  const int count = NumberOf(last_) + 1;
  start_ = MatX::Zero(n, count);
  DynamicsWorkspace ws(figure_);
  const JointIndex base = figure_.joint(hinges_.path[0]).parent;
  struct CarrierAt {
    Pose pose;
    Vec3 w, v;
  };
  const auto carrier_of = [&](const MotionLimit& at) {
    ComputePositions(figure_, at.X_WR, at.q, &ws);
    ComputeVelocities(figure_, at.root_w, at.root_v, at.qd, &ws);
    const BodyScratch& body = base.is_valid() ? ws.body(base) : ws.bodies[0];
    return CarrierAt{{body.R, body.p}, body.w, body.v};
  };
  const double h = animation_.rate.seconds_per_frame();
  const int begin = motion_.frames[0].frame;
  for (int t = 0; t < count; ++t) {
    // The frame before the start goes on as the motion behind it.
    const double frame = FrameOf(t);
    const int whole = std::clamp(static_cast<int>(std::floor(frame)), first_, last_ - 1);
    const MotionLimit& a = motion_.frames[static_cast<size_t>(whole - begin)].after;
    const MotionLimit& b = motion_.frames[static_cast<size_t>(whole + 1 - begin)].before;
    const double s = frame - whole;
    const CarrierAt x = carrier_of(a), z = carrier_of(b);
    const Vec3 turn = solve::TurnVector(x.pose.R.transpose() * z.pose.R);
    const Vec3 turned =
        CubicAt<Vec3>(Vec3::Zero(), x.pose.R.transpose() * x.w, turn,
                      solve::TurnVectorChange(turn) * (z.pose.R.transpose() * z.w), h, s);
    chain.carrier.push_back(
        {x.pose.R * solve::RotationBy(turned), CubicAt<Vec3>(x.pose.p, x.v, z.pose.p, z.v, h, s)});
    for (int k = 0; k < n; ++k) {
      const int j = hinges_.path[static_cast<size_t>(k)].value();
      start_(k, t) = CubicAt(a.q[j], a.qd[j], b.q[j], b.qd[j], h, s);
    }
  }
  problem_.given = start_;
  const int apart = std::max(1, (last_ - first_ + kIntervals / 2) / kIntervals);
  spline_frames_ = FramesThrough(first_, GoalFrames(), apart);
  for (const int knot : spline_frames_) problem_.knots.push_back(NumberOf(knot));
  // Objects that are held half-way count as held all the way.
  double mass = 0.0;  // of the figure
  chain.bodies.assign(static_cast<size_t>(count), BodiesAt((first_ + last_) / 2, &mass));
  const MotionFrame& at = motion_.frames[static_cast<size_t>(first_ - begin)];
  if (IsFalling(at, animation_)) TakeFall(mass);
}

// Bodies by hinge of the path, and the mass of the figure [kg], with what is held in a frame.
// Bodies beside the path move with it as on the first frame.
std::vector<RigidInertia> AimedLimb::BodiesAt(int frame, double* mass) const {
  const int n = static_cast<int>(hinges_.path.size());
  const int begin = motion_.frames[0].frame;
  const MotionFrame& held = motion_.frames[static_cast<size_t>(frame - begin)];
  const MotionLimit& at = motion_.frames[static_cast<size_t>(first_ - begin)].after;
  Figure loaded = figure_;
  for (size_t i = 0; i < held.objects.size(); ++i) {
    loaded = WithObject(loaded, animation_.held_objects[i], held.objects[i].holder);
  }
  *mass = loaded.total_mass();
  DynamicsWorkspace ws(figure_);
  ComputePositions(figure_, at.X_WR, at.q, &ws);
  std::vector<RigidInertia> bodies;
  for (int k = 0; k < n; ++k) {
    const size_t at_k = static_cast<size_t>(k);
    const JointIndex next = k + 1 < n ? hinges_.path[at_k + 1] : JointIndex();
    bodies.push_back(CarriedBody(hinges_.path[at_k], next, loaded, ws));
  }
  return bodies;
}

// Force that the limb's bodies ask of a figure in flight in the motion without torques.
void AimedLimb::TakeFall(double mass) {
  solve::Chain& chain = problem_.chain;
  chain.falling_mass = mass;
  std::vector<Vec3> sums;
  for (int t = 0; t < start_.cols(); ++t) {
    const solve::ChainPose pose =
        solve::PoseOfChain(chain, t, solve::TurnsOf(problem_, start_.col(t)));
    Vec3 sum = Vec3::Zero();
    for (size_t k = 0; k < pose.bodies.size(); ++k) {
      sum += chain.bodies[static_cast<size_t>(t)][k].mass * pose.bodies[k].g;
    }
    sums.push_back(sum);
  }
  chain.fall.assign(sums.size(), Vec3::Zero());
  for (size_t t = 1; t + 1 < sums.size(); ++t) {
    chain.fall[t] = (sums[t + 1] - 2.0 * sums[t] + sums[t - 1]) / (chain.step * chain.step);
  }
}

// The search for a throw begins with a cubic to its release.
void AimedLimb::SwingFromStart() {
  const int last = static_cast<int>(start_.cols()) - 1;
  const double h = (last - 1) * problem_.chain.step;
  for (int k = 0; k < static_cast<int>(hinges_.path.size()); ++k) {
    if (!hinges_.moves[static_cast<size_t>(k)] || k >= release_.angles.size()) continue;
    const double from = start_(k, 1);
    for (int t = 0; t <= last; ++t) {
      start_(k, t) =
          CubicAt(from, problem_.hinges[static_cast<size_t>(k)].start_rate, release_.angles[k],
                  release_.rates[k], h, (t - 1) / static_cast<double>(last - 1));
    }
  }
}

int AimedLimb::NumberOf(double frame) const {
  return 1 + static_cast<int>(std::lround((frame - first_) * per_frame_));
}

// Weights of the torques at the knots in the frames of the model: straight lines between knots.
MatX AimedLimb::Weights() const {
  MatX weights = MatX::Zero(problem_.chain.num_frames(), static_cast<int>(knots_.size()));
  for (int t = 1; t < problem_.chain.num_frames(); ++t) {
    const double frame = FrameOf(t);
    for (size_t k = 0; k + 1 < knots_.size(); ++k) {
      if (frame < knots_[k] || frame > knots_[k + 1]) continue;
      const double s = (frame - knots_[k]) / (knots_[k + 1] - knots_[k]);
      weights(t, static_cast<int>(k)) = 1.0 - s;
      weights(t, static_cast<int>(k) + 1) = s;
    }
  }
  if (goes_on_) weights.rightCols(1).setZero();
  return weights;
}

// Angles near which the search begins.
MatX AimedLimb::Begin(int detour) const {
  constexpr double kAside = 50.0 * kDegree;
  MatX angles = start_;
  const int k = std::abs(detour) - 1;
  if (k < 0 || k >= angles.rows() || !hinges_.moves[static_cast<size_t>(k)]) return angles;
  const int last = static_cast<int>(angles.cols()) - 1;
  const solve::AimHinge& hinge = problem_.hinges[static_cast<size_t>(k)];
  for (int t = 2; t < last; ++t) {
    const double s = (t - 1) / static_cast<double>(last - 1);
    const double aside = (detour > 0 ? kAside : -kAside) * 4.0 * s * (1.0 - s);
    angles(k, t) = std::clamp(angles(k, t) + aside, hinge.lower, hinge.upper);
  }
  return angles;
}

void AimedLimb::Solve(const LimbWay& way) {
  // Pairs come near each other at the goals alone, over the last frames before them.
  constexpr double kNear = 0.25;  // of the time
  const int count = problem_.chain.num_frames();
  problem_.clearance = VecX::Constant(count, way.clearance);
  for (const AimGoal& goal : goals_) {
    const int at = NumberOf(goal.frame);
    const double over = kNear * (count - 2);
    for (int t = 0; t < count; ++t) {
      const double share = std::min(1.0, std::abs(t - at) / over);
      problem_.clearance[t] = std::min(problem_.clearance[t], share * way.clearance);
    }
  }
  problem_.acceleration = way.smoothness * solve::AimProblem().acceleration;
  solve::AimSolver solver(problem_, Begin(way.detour));
  const solve::AimedMotion found = solver.Solve();
  iterations_ = found.report.iterations;
  angles_ = found.angles;
  path_torques_ = found.torques;
  const MatX weights = Weights();
  changes_ = solver.ChangesWith(weights);
  const int last = static_cast<int>(found.torques.cols()) - 2;
  const MatX rows = weights.middleRows(1, last);
  MatX normal = rows.transpose() * rows;
  normal.diagonal().array() += 1e-9;
  const Eigen::LDLT<MatX> factor(normal);
  std::vector<double> all;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    if (!hinges_.moves[k]) continue;
    const VecX torque = found.torques.row(static_cast<int>(k)).segment(1, last).transpose();
    const VecX keys = factor.solve(rows.transpose() * torque);
    all.insert(all.end(), keys.data(), keys.data() + keys.size());
  }
  torques_ = Eigen::Map<const VecX>(all.data(), static_cast<int>(all.size()));
}

double AimedLimb::MostMuscle() const {
  double most = 0.0;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    const Joint& joint = figure_.joint(hinges_.path[k]);
    if (!joint.strength || !hinges_.moves[k]) continue;
    for (int t = 1; t + 1 < angles_.cols(); ++t) {
      const int row = static_cast<int>(k);
      const double tau = path_torques_(row, t);
      const double rate = (angles_(row, t + 1) - angles_(row, t - 1)) / (2.0 * problem_.chain.step);
      const StrengthLimits limits = joint.strength->At(angles_(row, t), rate);
      most = std::max(most, std::abs(tau) / (tau > 0.0 ? limits.positive : limits.negative).torque);
    }
  }
  return most;
}

double AimedLimb::MostBeyond() const {
  double most = 0.0;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    if (!hinges_.moves[k]) continue;
    const Joint& joint = figure_.joint(hinges_.path[k]);
    const auto path = angles_.row(static_cast<int>(k)).rightCols(angles_.cols() - 1);
    most = std::max({most, path.maxCoeff() - joint.upper, joint.lower - path.minCoeff()});
  }
  return most;
}

// Central differences; at the end those of the parabola through the last three frames.
VecX AimedLimb::RatesAt(int frame) const {
  const int t = NumberOf(frame);
  const double h = problem_.chain.step;
  if (t + 1 < angles_.cols()) return (angles_.col(t + 1) - angles_.col(t - 1)) / (2.0 * h);
  return (1.5 * angles_.col(t) - 2.0 * angles_.col(t - 1) + 0.5 * angles_.col(t - 2)) / h;
}

MatX AimedLimb::RateChange(int frame) const {
  const int t = NumberOf(frame);
  const double h = problem_.chain.step;
  if (t + 1 < angles_.cols()) return (ChangeOf(t + 1) - ChangeOf(t - 1)) / (2.0 * h);
  return (1.5 * ChangeOf(t) - 2.0 * ChangeOf(t - 1) + 0.5 * ChangeOf(t - 2)) / h;
}

MatX AimedLimb::ChangeOf(int t) const {
  const MatX& all = changes_[static_cast<size_t>(t)];
  const int count = static_cast<int>(knots_.size());
  MatX change(all.rows(), torques_.size());
  int to = 0;
  for (size_t k = 0; k < hinges_.path.size(); ++k) {
    if (!hinges_.moves[k]) continue;
    change.middleCols(to, count) = all.middleCols(static_cast<int>(k) * count, count);
    to += count;
  }
  return change;
}

}  // namespace hazumi::makers
