#include "engine/solve/fill_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/matrix/cholesky.h"
#include "engine/solve/band_system.h"
#include "engine/solve/turn_vector.h"

namespace hazumi::solve {

namespace {

class FillSolver {
 public:
  FillSolver(const Chain& chain, const FillWeights& weights, Turns* turns)
      : chain_(chain),
        weights_(weights),
        unknowns_(chain),
        turns_(*turns),
        reference_(*turns),
        system_(unknowns_.per_frame() * chain.num_frames(), 3 * unknowns_.per_frame()) {}

  SquaresReport Run() {
    if (chain_.num_frames() < 3 || unknowns_.per_frame() == 0) return {};
    if (weights_.torque > 0.0) unit_ = Unit();
    return Minimize({}, this, &system_);
  }

  double Linearize(BandSystem* system) {
    TakePoses(turns_, &poses_);
    FreezeMetric();
    return Terms(turns_, poses_, system);
  }

  double CostAfter(const VecX& step) {
    moved_ = turns_;
    for (int t = 0; t < chain_.num_frames(); ++t) {
      for (int j = 0; j < chain_.num_joints(); ++j) {
        if (unknowns_.size(j) == 0 || IsKnown(t, j)) continue;
        Mat3& turn = moved_[static_cast<size_t>(t)][static_cast<size_t>(j)];
        turn = TurnedOn(turn, chain_.joints[static_cast<size_t>(j)],
                        step.segment(Number(t, j), unknowns_.size(j)));
      }
    }
    TakePoses(moved_, &moved_poses_);
    return Terms(moved_, moved_poses_, nullptr);
  }

  void Accept() { turns_ = moved_; }

 private:
  using Poses = std::vector<ChainPose>;

  bool IsKnown(int t, int j) const {
    return chain_.is_known[static_cast<size_t>(t)][static_cast<size_t>(j)] != 0;
  }
  const Mat3& Turn(const Turns& turns, int t, int j) const {
    return turns[static_cast<size_t>(t)][static_cast<size_t>(j)];
  }

  void TakePoses(const Turns& turns, Poses* poses) const {
    poses->clear();
    if (weights_.torque == 0.0) return;
    for (int t = 0; t < chain_.num_frames(); ++t) {
      poses->push_back(PoseOfChain(chain_, t, turns[static_cast<size_t>(t)]));
    }
  }

  // The root of the mean inertia that the first joint carries [kg^1/2 m].
  double Unit() {
    TakePoses(turns_, &poses_);
    double sum = 0.0;
    int count = 0;
    for (int t = 0; t < chain_.num_frames(); ++t) {
      if (!IsKnown(t, 0)) continue;
      const auto& bodies = chain_.bodies[static_cast<size_t>(t)];
      for (size_t k = 0; k < bodies.size(); ++k) {
        const Vec3 d =
            poses_[static_cast<size_t>(t)].bodies[k].g - poses_[static_cast<size_t>(t)].bodies[0].o;
        sum += bodies[k].mass * d.squaredNorm() + bodies[k].I_com.trace() / 3.0;
      }
      ++count;
    }
    return std::sqrt(sum / std::max(count, 1));
  }

  // Inverse Cholesky factors of the inertias that the joints carry, constant during an iteration;
  // zero for a joint that carries no mass.
  void FreezeMetric() {
    if (weights_.torque == 0.0) return;
    metric_.resize(static_cast<size_t>(chain_.num_frames()));
    for (int t = 0; t < chain_.num_frames(); ++t) {
      std::vector<MatX>& metric = metric_[static_cast<size_t>(t)];
      metric = CarriedInertias(chain_, t, poses_[static_cast<size_t>(t)]);
      for (MatX& H : metric) {
        const int n = static_cast<int>(H.rows());
        const double scale = n > 0 ? H.diagonal().maxCoeff() : 0.0;
        constexpr double kNothing = 1e-12;  // [kg m^2]
        if (!(scale > kNothing) || FactorCholesky(H) >= 0) {
          H.setZero();
          continue;
        }
        MatX inverse = MatX::Identity(n, n) / unit_;
        H.triangularView<Eigen::Lower>().solveInPlace(inverse);
        H = weights_.torque * inverse;
      }
    }
  }

  // Second differences from a frame that stands for a velocity are half of the acceleration.
  double EndWeight(int t) const {
    const bool is_end = t == 1 || t + 2 == chain_.num_frames();
    return chain_.has_end_rates && is_end ? std::sqrt(2.0) : 1.0;
  }

  // The axes of a joint in its own frame; none where it is known, for nothing changes there.
  Axes FreeAxes(const Turns& turns, int t, int j) const {
    if (IsKnown(t, j)) return Axes(3, 0);
    return AxesBehind(Turn(turns, t, j), chain_.joints[static_cast<size_t>(j)]);
  }
  int Number(int t, int j) const { return t * unknowns_.per_frame() + unknowns_.first(j); }

  // Sum of squares; adds residuals and derivatives to `system`, if there is one.
  double Terms(const Turns& turns, const Poses& poses, BandSystem* system) {
    double cost = 0.0;
    for (int t = 1; t + 1 < chain_.num_frames(); ++t) {
      if (weights_.torque > 0.0) cost += TorqueTerm(poses, t, system);
      for (int j = 0; j < chain_.num_joints(); ++j) {
        if (unknowns_.size(j) > 0) cost += AccelerationTerm(turns, t, j, system);
      }
    }
    for (int j = 0; j < chain_.num_joints(); ++j) {
      if (unknowns_.size(j) == 0 || weights_.velocity == 0.0) continue;
      for (int t = 0; t + 1 < chain_.num_frames(); ++t) cost += VelocityTerm(turns, t, j, system);
    }
    for (const GivenRate& given : chain_.rates) cost += RateTerm(turns, given, system);
    for (int j = 0; j < chain_.num_joints(); ++j) {
      if (unknowns_.size(j) == 0 || weights_.standing == 0.0) continue;
      for (int t = 1; t + 1 < chain_.num_frames(); ++t) cost += StandingTerm(turns, t, j, system);
    }
    return cost;
  }

  double RateTerm(const Turns& turns, const GivenRate& given, BandSystem* system) const {
    constexpr double kWeight = 1000.0;  // [1/s]
    const double w = kWeight / (2.0 * chain_.step);
    const int t = given.frame, j = given.joint;
    const Mat3& now = Turn(turns, t, j);
    const Vec3 f1 = TurnVector(Turn(turns, t - 1, j).transpose() * now);
    const Vec3 f2 = TurnVector(now.transpose() * Turn(turns, t + 1, j));
    const double off = w * given.along.dot(f1 + f2) - kWeight * given.rate;
    if (!system) return off * off;
    const int size = unknowns_.size(j);
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9> J =
        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9>::Zero(3, 3 * size);
    const Mat3 only = given.along * given.along.transpose() / given.along.norm();
    PutChange(turns, t - 1, j, -w * only * TurnVectorChange(f1).transpose(), J.middleCols(0, size));
    PutChange(turns, t + 1, j, w * only * TurnVectorChange(f2), J.middleCols(2 * size, size));
    AddOfJoint(t - 1, j, J, 3, off * given.along.normalized(), system);
    return off * off;
  }

  double TorqueTerm(const Poses& poses, int t, BandSystem* system) {
    const size_t at = static_cast<size_t>(t);
    const int n = unknowns_.per_frame();
    ChainMoments moments(chain_, t, poses[at - 1], poses[at], poses[at + 1]);
    VecX r(n);
    for (int j = 0; j < chain_.num_joints(); ++j) {
      r.segment(unknowns_.first(j), unknowns_.size(j)) =
          EndWeight(t) * (metric_[at][static_cast<size_t>(j)] * moments.Torques(j));
    }
    if (!system) return r.squaredNorm();
    MatX J = MatX::Zero(n, 3 * n);
    for (int s = -1; s <= 1; ++s) {
      for (int j = 0; j < chain_.num_joints(); ++j) {
        if (IsKnown(t + s, j)) continue;
        for (int e = 0; e < unknowns_.size(j); ++e) {
          moments.Differentiate(s, j, e, unknowns_, J.col((s + 1) * n + unknowns_.first(j) + e));
        }
      }
    }
    for (int j = 0; j < chain_.num_joints(); ++j) {
      if (unknowns_.size(j) == 0) continue;
      auto rows = J.middleRows(unknowns_.first(j), unknowns_.size(j));
      rows = EndWeight(t) * (metric_[at][static_cast<size_t>(j)] * rows).eval();
    }
    system->Add((t - 1) * n, J, r);
    return r.squaredNorm();
  }

  // Adds a residual of one joint: derivatives by its axes at some frames in a row.
  void AddOfJoint(int t, int j, const Eigen::Ref<const MatX>& J, int frames, const Vec3& r,
                  BandSystem* system) const {
    const int n = unknowns_.per_frame(), size = unknowns_.size(j);
    MatX wide = MatX::Zero(3, (frames - 1) * n + size);
    for (int s = 0; s < frames; ++s) wide.middleCols(s * n, size) = J.middleCols(s * size, size);
    system->Add(Number(t, j), wide, r);
  }

  // Derivative of a residual by the axes of a joint at a frame; zero where it is known.
  template <typename Derived>
  void PutChange(const Turns& turns, int t, int j, const Mat3& change,
                 Eigen::MatrixBase<Derived>&& block) const {
    const Axes axes = FreeAxes(turns, t, j);
    if (axes.cols() > 0) block = change * axes;
  }

  double AccelerationTerm(const Turns& turns, int t, int j, BandSystem* system) const {
    const double w = EndWeight(t) * weights_.acceleration / (chain_.step * chain_.step);
    const Mat3& now = Turn(turns, t, j);
    const Vec3 f1 = TurnVector(Turn(turns, t - 1, j).transpose() * now);
    const Vec3 f2 = TurnVector(now.transpose() * Turn(turns, t + 1, j));
    const Vec3 r = w * (f2 - f1);
    if (!system) return r.squaredNorm();
    const Mat3 V1 = TurnVectorChange(f1), V2 = TurnVectorChange(f2);
    const int size = unknowns_.size(j);
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9> J =
        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9>::Zero(3, 3 * size);
    PutChange(turns, t - 1, j, w * V1.transpose(), J.middleCols(0, size));
    PutChange(turns, t, j, -w * (V2.transpose() + V1), J.middleCols(size, size));
    PutChange(turns, t + 1, j, w * V2, J.middleCols(2 * size, size));
    AddOfJoint(t - 1, j, J, 3, r, system);
    return r.squaredNorm();
  }

  double VelocityTerm(const Turns& turns, int t, int j, BandSystem* system) const {
    const double w = weights_.velocity / chain_.step;
    const Vec3 d1 = TurnVector(Turn(reference_, t, j).transpose() * Turn(turns, t, j));
    const Vec3 d2 = TurnVector(Turn(reference_, t + 1, j).transpose() * Turn(turns, t + 1, j));
    const Vec3 r = w * (d2 - d1);
    if (!system) return r.squaredNorm();
    const int size = unknowns_.size(j);
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6> J =
        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6>::Zero(3, 2 * size);
    PutChange(turns, t, j, -w * TurnVectorChange(d1), J.middleCols(0, size));
    PutChange(turns, t + 1, j, w * TurnVectorChange(d2), J.middleCols(size, size));
    AddOfJoint(t, j, J, 2, r, system);
    return r.squaredNorm();
  }

  double StandingTerm(const Turns& turns, int t, int j, BandSystem* system) const {
    if (!IsKnown(t, j)) return 0.0;
    const double w = weights_.standing / (2.0 * chain_.step);
    const Vec3 f = TurnVector(Turn(turns, t - 1, j).transpose() * Turn(turns, t + 1, j));
    const Vec3 r = w * f;
    if (!system) return r.squaredNorm();
    const Mat3 V = TurnVectorChange(f);
    const int size = unknowns_.size(j);
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9> J =
        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 9>::Zero(3, 3 * size);
    PutChange(turns, t - 1, j, -w * V.transpose(), J.middleCols(0, size));
    PutChange(turns, t + 1, j, w * V, J.middleCols(2 * size, size));
    AddOfJoint(t - 1, j, J, 3, r, system);
    return r.squaredNorm();
  }

  const Chain& chain_;
  FillWeights weights_;
  ChainUnknowns unknowns_;
  Turns& turns_;
  Turns reference_;
  BandSystem system_;
  double unit_ = 1.0;
  Poses poses_;
  Turns moved_;  // after the step that is tried
  Poses moved_poses_;
  std::vector<std::vector<MatX>> metric_;  // by frame and joint
};

}  // namespace

SquaresReport SolveFill(const Chain& chain, const FillWeights& weights, Turns* turns) {
  return FillSolver(chain, weights, turns).Run();
}

SquaresReport SolveSpline(const Chain& chain, Turns* turns) {
  return FillSolver(chain, {0.0, 1.0, 0.0, 0.0}, turns).Run();
}

}  // namespace hazumi::solve
