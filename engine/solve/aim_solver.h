#pragma once

// Motion of the hinges of a limb from a state to what is asked of it, with the least
//
//   sum over frames  dt / T (sum over hinges (tau_i / S_i)^2 + w_q^2 q_i''^2
//                            + w_b^2 beyond(|tau_i| / S_i, most)^2 + w_l^2 beyond(q_i, limits)^2
//                            + sum over pairs w_o^2 beyond(distance, clearance)^2)
//   + sum over angles asked for w_a^2 (q_i - angle)^2 + sum over rates w_r^2 (q_i' - rate)^2
//
// tau [N m]: torques that muscles have to give, M (q'' + C q') + b: what friction takes and what
// the limb does by itself costs nothing [METHOD 2.3]. S: what counts as 1; dt: from frame to frame,
// T: all of them. Each angle is a cubic spline over time, whose coefficients are unknown:
//
//   q(t) = sum over k of c_k B_k(t),  c_0 = q_0,  c_1 = q_0 + q_0' d / 3,
//
// d: between the first two knots, which all are where the torques may have keys: a hinge of
// constant inertia then asks for a torque that is straight between keys. q' and q'' are central
// differences. Gauss and Newton's method, damped as Levenberg does.

#include <optional>
#include <vector>

#include "engine/collision/shapes.h"
#include "engine/solve/chain.h"
#include "engine/solve/least_squares.h"

namespace hazumi::solve {

struct AimHinge {
  Mat3 before = Mat3::Identity();   // its turn against the body before, at angle 0
  bool moves = true;                // false: its angles are given
  double friction = 0.0;            // C [1/s]
  double strength = 1.0;            // S [N m]
  bool is_bounded = true;           // `most` applies
  double lower = 0.0, upper = 0.0;  // [rad]
  double start_rate = 0.0;          // [rad/s]
};

// An angle that a hinge has to have in a frame.
struct AimAngle {
  int frame = 0, hinge = 0;
  double angle = 0.0;  // [rad]
};

// A rate that a hinge has to have in a frame.
struct AimRate {
  int frame = 0, hinge = 0;
  double rate = 0.0;  // [rad/s]
};

// A capsule that turns with a hinge, in its frame, and what it stays out of.
struct AimPair {
  int hinge = 0;
  Capsule capsule;
  Obstacle obstacle;  // in the world
};

struct AimProblem {
  // Each joint has one axis, behind it. Frame 1 is the start; frame 0 stands for the rates there.
  Chain chain;
  std::vector<AimHinge> hinges;
  MatX given;                  // angles of the hinges that do not move: hinges x frames [rad]
  std::vector<int> knots;      // frames, from 1 to the last
  double most = 1.0;           // share of S that a torque may have
  double acceleration = 2e-4;  // w_q [s^2]: 500 rad/s^2 count as a tenth of S
  std::vector<AimAngle> angles;
  std::vector<AimRate> rates;
  std::vector<AimPair> pairs;
  VecX clearance;  // that pairs keep, by frame; of no size: there are no pairs [m]
};

// Turns of the joints with these angles.
std::vector<Mat3> TurnsOf(const AimProblem& problem, const VecX& angles);

struct AimedMotion {
  MatX angles;   // hinges x frames [rad]
  MatX torques;  // hinges x frames, 0 on the first and the last [N m]
  SquaresReport report;
};

class AimSolver {
 public:
  // `angles`: hinges x frames, near which to begin.
  AimSolver(const AimProblem& problem, const MatX& angles);

  AimedMotion Solve();

  // After Solve: how the angles of each frame change with weights of torques over time. `weights`:
  // frames x number of weights, the same for each hinge; returns by frame hinges x (weights of the
  // first hinge, of the second ...) [rad / N m]. What was asked for is not kept.
  std::vector<MatX> ChangesWith(const MatX& weights) const;

  // For Minimize.
  double Linearize(BandSystem* system) { return Terms(coefficients_, system); }
  double CostAfter(const VecX& step);
  void Accept() { coefficients_ = moved_; }

 private:
  struct Changes {  // of the torques of a frame, by the angles of the frame before, now and after
    MatX before, now, after;
  };

  int num_hinges() const { return problem_.chain.num_joints(); }
  int num_frames() const { return problem_.chain.num_frames(); }
  int num_coefficients() const { return static_cast<int>(basis_.cols()); }
  double ShareAt(int t) const;
  bool IsFree(int coefficient, int hinge) const;
  int Number(int coefficient, int hinge) const { return (coefficient - 2) * num_hinges() + hinge; }
  void FillBasis();
  void FitTo(const MatX& angles);
  MatX AnglesOf(const MatX& coefficients) const;
  double Terms(const MatX& coefficients, BandSystem* system);
  double TorqueTerm(const MatX& angles, int t, BandSystem* system);
  double OwnTerms(const MatX& angles, int t, int j, BandSystem* system) const;
  double PairTerms(const MatX& angles, int t, BandSystem* system) const;
  // Adds residuals with their derivatives by all angles, or those of one hinge, on `count` frames
  // from `first` on.
  double Add(int first, int count, const MatX& J, const VecX& r, BandSystem* system) const;
  double AddOf(int hinge, int first, const VecX& change, double r, BandSystem* system) const;

  const AimProblem& problem_;
  ChainUnknowns unknowns_;
  double share_;               // root of a frame's part of the whole time
  MatX basis_;                 // frames x coefficients
  MatX coefficients_, moved_;  // hinges x coefficients
  bool has_torques_ = true;
  MatX torques_;
  std::vector<Changes> changes_;  // by frame
};

}  // namespace hazumi::solve
