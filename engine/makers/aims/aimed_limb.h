#pragma once

// Internal. A limb of a region that is aimed: a model of it, the motion with which that arrives,
// and the torques that the motion asks for.

#include <optional>
#include <vector>

#include "engine/makers/aims/aimed_paths.h"
#include "engine/makers/throws/release_pose.h"
#include "engine/solve/aim_solver.h"

namespace hazumi::makers {

// Kind of motion that is looked for.
struct LimbWay {
  double smoothness = 1.0;  // how many times as much angular acceleration counts as usual
  double clearance = 0.01;  // kept from planes and boxes on the way [m]
  // Beginning of the search: 0: the shortest way; k or -k: hinge number k - 1 of the path is turned
  // aside on the way.
  int detour = 0;
};

class AimedLimb {
 public:
  // `motion`: of the animation without the torques that are looked for, up to the last goal.
  AimedLimb(AimedHinges hinges, const DynamicsRegion& region, std::vector<AimGoal> goals,
            double most, const Animation& animation, const Motion& motion);
  AimedLimb(const AimedLimb&) = delete;
  AimedLimb& operator=(const AimedLimb&) = delete;

  void Solve(const LimbWay& way);

  const AimedHinges& hinges() const { return hinges_; }
  const std::vector<AimGoal>& goals() const { return goals_; }
  // Frames of its torque keys.
  const std::vector<int>& knots() const { return knots_; }
  // Torques at the knots, hinge by hinge of those that move [N m].
  const VecX& torques() const { return torques_; }
  // Torque of a hinge that counts as 1, by number of torques() [N m].
  const VecX& strengths() const { return strengths_; }
  // Angles [rad] and rates [rad/s] of the path as the model has them, by frame of the animation,
  // and their derivatives by torques() [rad / N m, rad/s / N m].
  VecX AnglesAt(int frame) const { return angles_.col(NumberOf(frame)); }
  VecX RatesAt(int frame) const;
  MatX AngleChange(int frame) const { return ChangeOf(NumberOf(frame)); }
  MatX RateChange(int frame) const;
  int iterations() const { return iterations_; }
  // Frames of the animation between which the path is a cubic.
  const std::vector<int>& spline_frames() const { return spline_frames_; }
  // Pose and rates with which the goal that throws lets go.
  const Release& release() const { return release_; }
  // Largest torque that the path asks for, as a share of what its hinge can give there; 0 if no
  // strength is known.
  double MostMuscle() const;
  // Largest angle of the path beyond a limit [rad].
  double MostBeyond() const;
  // Largest depth of the limb in planes and boxes in a motion, up to the last goal [m].
  double DepthIn(const Motion& motion) const;
  // A goal whose place the limb cannot bring its point to, or throw to, and how far off it stays.
  struct OutOfReach {
    AimGoal goal;
    double distance = 0.0;  // [m]
  };
  const std::optional<OutOfReach>& out_of_reach() const { return out_of_reach_; }

 private:
  void BuildChain(const DynamicsRegion& region, double most);
  void AddFrames();
  std::vector<int> GoalFrames() const;
  std::vector<RigidInertia> BodiesAt(int frame, double* mass) const;
  void TakeFall(double mass);
  void TakeStrengths();
  void TakePairs();
  double DepthAt(int t, const VecX& angles) const;
  void AskForGoals();
  void AskForPlace(const AimGoal& goal, int t);
  void AskForThrow(const AimGoal& goal, int t);
  void SwingFromStart();
  MatX Begin(int detour) const;
  double FrameOf(int t) const { return first_ + (t - 1) / static_cast<double>(per_frame_); }
  int NumberOf(double frame) const;
  MatX Weights() const;
  MatX ChangeOf(int t) const;

  const Animation& animation_;
  const Figure& figure_;
  const Motion& motion_;
  AimedHinges hinges_;
  std::vector<AimGoal> goals_;
  int first_ = 0, last_ = 0;  // frames of the animation: the start, the last goal
  bool goes_on_ = false;      // the region does, behind the last goal
  int per_frame_ = 1;
  std::vector<int> knots_, spline_frames_;
  Release release_;
  solve::AimProblem problem_;
  MatX start_;                  // angles, hinges x frames of the chain
  MatX angles_, path_torques_;  // as solved
  std::vector<MatX> changes_;   // of the angles with the torques at the knots, by frame
  VecX torques_, strengths_;
  int iterations_ = 0;
  std::optional<OutOfReach> out_of_reach_;
};

}  // namespace hazumi::makers
