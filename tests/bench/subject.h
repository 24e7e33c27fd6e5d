#pragma once

// What is timed: programs that answer the questions of dynamics about one figure on a fixed root.

#include <memory>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/types.h"

namespace hazumi::bench {

constexpr double kGravity = 9.81;  // [m/s^2] along -z

struct Question {
  VecX q, qd;  // [rad, rad/s], by JointIndex
  VecX qdd;    // for the inverse dynamics [rad/s^2]
  VecX tau;    // for the forward dynamics [N m]
};

// One program with one figure. Each call takes the state from the question, so that nothing known
// from an earlier call helps, and returns false if the program has no such call.
class Subject {
 public:
  Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;
  virtual ~Subject() = default;

  virtual bool InverseDynamics(const Question&, VecX* /*tau*/) { return false; }
  virtual bool Bias(const Question&, VecX* /*b*/) { return false; }
  // Where H is null the program may leave the matrix in the form it keeps it in.
  virtual bool InertiaMatrix(const Question&, MatX* /*H*/) { return false; }
  virtual bool ForwardDynamics(const Question&, VecX* /*qdd*/) { return false; }
};

// `figure` outlives the subject.
using SubjectMaker = std::unique_ptr<Subject> (*)(const Figure& figure);

struct NamedMaker {
  std::string name;
  SubjectMaker make;
};

// Inverse dynamics of one frame, by the recursion in world axes; forward dynamics by the equations
// of a region.
std::unique_ptr<Subject> MakeHazumi(const Figure& figure);
// H by unit accelerations and a dense Cholesky factorisation, as printed: O(N^3).
std::unique_ptr<Subject> MakeHazumiPaperWay(const Figure& figure);
std::unique_ptr<Subject> MakeMujoco(const Figure& figure);
std::unique_ptr<Subject> MakeSimbody(const Figure& figure);
std::unique_ptr<Subject> MakeBullet(const Figure& figure);
std::unique_ptr<Subject> MakeDart(const Figure& figure);

// The same peers with a ball joint for every three hinges; forward dynamics only, asked and
// answered in the hinges' terms, to check the models of the swings.
std::unique_ptr<Subject> MakeMujocoWithBalls(const Figure& figure);
std::unique_ptr<Subject> MakeSimbodyWithBalls(const Figure& figure);
std::unique_ptr<Subject> MakeBulletWithBalls(const Figure& figure);
std::unique_ptr<Subject> MakeDartWithBalls(const Figure& figure);

}  // namespace hazumi::bench
