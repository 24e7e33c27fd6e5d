#include "engine/makers/fills/limb_fill.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/makers/carried_body.h"
#include "engine/solve/fill_solver.h"
#include "engine/solve/turn_vector.h"

namespace hazumi::makers {

namespace {

using solve::RotationBy;
using solve::TurnVector;

// Frames of the carrier that are taken together, as a share of the frames between two keys: sparse
// keys know nothing of faster motion of the body. [METHOD 13.2]
constexpr double kCarrierSmoothing = 1.0 / 20.0;
constexpr double kLeastSmoothing = 0.1;  // [frames]

// Weights of a snap from -1 to 1; those of 0 were measured against captured motion.
solve::FillWeights WeightsOf(double snap) {
  solve::FillWeights weights;
  if (snap < 0.0) {
    weights.velocity *= 1.0 + 0.75 * snap;
    weights.acceleration *= 1.0 + 0.5 * snap;
  } else {
    constexpr double kStanding = 300.0;  // [1/s]
    weights.standing = kStanding * snap * snap;
  }
  return weights;
}

// Gaussian means of poses, with a width of its own at each [frames]. Widths end at the ends.
std::vector<Pose> Smoothed(const std::vector<Pose>& poses, const std::vector<double>& widths) {
  const int n = static_cast<int>(poses.size());
  std::vector<Pose> smooth = poses;
  for (int t = 0; t < n; ++t) {
    const double width = std::max(kLeastSmoothing, widths[static_cast<size_t>(t)]);
    const int reach = std::min(std::min(t, n - 1 - t), static_cast<int>(3.0 * width));
    const Mat3& R = poses[static_cast<size_t>(t)].R;
    Vec3 p = Vec3::Zero(), turn = Vec3::Zero();
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k) {
      const double weight = std::exp(-0.5 * k * k / (width * width));
      const Pose& other = poses[t + k];
      sum += weight;
      p += weight * other.p;
      turn += weight * TurnVector(R.transpose() * other.R);
    }
    smooth[static_cast<size_t>(t)] = {R * RotationBy(turn / sum), p / sum};
  }
  return smooth;
}

class LimbFill {
 public:
  LimbFill(const ProjectFill& fill, const Animation& animation, FilledFigure* figure)
      : fill_(fill), animation_(animation), figure_(*animation.figure), filled_(*figure) {}

  void Fill(const Limb& limb, const LimbSplines& splines) {
    if (!Range(limb, splines)) return;
    chain_ = {};
    chain_.step = animation_.rate.seconds_per_frame();
    chain_.has_end_rates = has_end_rates_;
    const bool in_world = fill_.relative_to == FillFrame::kWorld;
    if (in_world && !IsLeg(limb, figure_)) chain_.gravity = {0.0, 0.0, -animation_.gravity};
    AddJoints(limb, splines);
    solve::Turns turns = AddFrames(limb, splines);
    if (in_world) {
      chain_.carrier = Smoothed(chain_.carrier, Widths(limb, splines));
    } else {
      std::fill(chain_.carrier.begin(), chain_.carrier.end(), Pose());
    }
    solve::SolveFill(chain_, WeightsOf(fill_.snap), &turns);
    for (size_t k = 0; k < limb.size(); ++k) {
      const auto spline = splines.find(limb[k]);
      if (spline == splines.end()) continue;
      const FilledJoint& joint = *spline->second.first;
      for (int f = joint.first; f <= joint.last; ++f) {
        spline->second.second->At(f, joint) = turns[static_cast<size_t>(f - first_)][k];
      }
    }
  }

 private:
  bool Range(const Limb& limb, const LimbSplines& splines) {
    bool any = false;
    for (const GroupIndex group : limb) {
      const auto spline = splines.find(group);
      if (spline == splines.end()) continue;
      const FilledJoint& joint = *spline->second.first;
      first_ = any ? std::min(first_, joint.first) : joint.first;
      last_ = any ? std::max(last_, joint.last) : joint.last;
      any = true;
    }
    bool is_free_before = true, is_free_after = true;
    for (const auto& [group, spline] : splines) {
      is_free_before &= spline.first->is_free_before;
      is_free_after &= spline.first->is_free_after;
    }
    if (!is_free_before) --first_;
    if (!is_free_after) ++last_;
    has_end_rates_ = !is_free_before && !is_free_after;
    return any;
  }

  void AddJoints(const Limb& limb, const LimbSplines& splines) {
    for (size_t k = 0; k < limb.size(); ++k) {
      const Joint& hinge = figure_.joint(figure_.group(limb[k]).first);
      const auto spline = splines.find(limb[k]);
      chain_.joints.push_back({hinge.X_PJ.p, {}});
      if (spline == splines.end()) continue;
      chain_.joints.back().axes = spline->second.second->axes;
      for (solve::GivenRate given : spline->second.second->rates) {
        given.frame += spline->second.first->first - 1 - first_;
        given.joint = static_cast<int>(k);
        chain_.rates.push_back(given);
      }
    }
  }

  solve::Turns AddFrames(const Limb& limb, const LimbSplines& splines) {
    solve::Turns turns;
    const JointIndex base = figure_.joint(figure_.group(limb[0]).first).parent;
    for (int f = first_; f <= last_; ++f) {
      const int within = std::clamp(f, filled_.first(), filled_.last());
      const DynamicsWorkspace& ws = filled_.Bodies(within);
      const BodyScratch& carrier = base.is_valid() ? ws.body(base) : ws.bodies[0];
      chain_.carrier.push_back({carrier.R, carrier.p});
      std::vector<Mat3> now;
      std::vector<RigidInertia> bodies;
      std::vector<char> is_known;
      Mat3 before = carrier.R;
      for (size_t k = 0; k < limb.size(); ++k) {
        const JointGroup& group = figure_.group(limb[k]);
        const BodyScratch& body = ws.body(group.last());
        const auto spline = splines.find(limb[k]);
        const bool is_filled = spline != splines.end();
        now.push_back(before.transpose() * body.R);
        if (is_filled) {
          const FilledJoint& joint = *spline->second.first;
          if (f >= joint.first - 1 && f <= joint.last + 1) {
            now.back() = spline->second.second->At(f, joint);
          }
        }
        is_known.push_back(!is_filled || spline->second.first->IsKnown(f) ? 1 : 0);
        const JointIndex next =
            k + 1 < limb.size() ? figure_.group(limb[k + 1]).first : JointIndex();
        bodies.push_back(CarriedBody(group.last(), next, figure_, ws));
        before = body.R;
      }
      turns.push_back(std::move(now));
      chain_.bodies.push_back(std::move(bodies));
      chain_.is_known.push_back(std::move(is_known));
    }
    // The carrier moves on beyond the animation's ends.
    std::vector<Pose>& carrier = chain_.carrier;
    if (carrier.size() > 2 && first_ < filled_.first()) {
      carrier[0] = carrier[1] * carrier[2].Inverse() * carrier[1];
    }
    if (const size_t n = carrier.size(); n > 2 && last_ > filled_.last()) {
      carrier[n - 1] = carrier[n - 2] * carrier[n - 3].Inverse() * carrier[n - 2];
    }
    return turns;
  }

  // Width of the smoothing by frame: a share of the frames between the keys around it.
  std::vector<double> Widths(const Limb& limb, const LimbSplines& splines) const {
    std::vector<double> widths(chain_.carrier.size(), 0.0);
    const FilledJoint* joint = nullptr;
    for (const GroupIndex group : limb) {
      const auto spline = splines.find(group);
      if (spline != splines.end() && !joint) joint = spline->second.first;
    }
    const auto put = [&](int frame, double width) {
      if (frame >= first_ && frame <= last_) widths[static_cast<size_t>(frame - first_)] = width;
    };
    int before = joint->first;
    for (int f = joint->first + 1; f <= joint->last; ++f) {
      if (!joint->IsKeyed(f)) continue;
      for (int k = before; k <= f; ++k) put(k, kCarrierSmoothing * (f - before));
      before = f;
    }
    put(first_, widths[static_cast<size_t>(std::max(joint->first, first_) - first_)]);
    put(last_, widths[static_cast<size_t>(std::min(joint->last, last_) - first_)]);
    return widths;
  }

  const ProjectFill& fill_;
  const Animation& animation_;
  const Figure& figure_;
  FilledFigure& filled_;
  int first_ = 0, last_ = 0;
  bool has_end_rates_ = false;
  solve::Chain chain_;
};

}  // namespace

void FillLimb(const Limb& limb, const LimbSplines& splines, const ProjectFill& fill,
              const Animation& animation, FilledFigure* figure) {
  LimbFill(fill, animation, figure).Fill(limb, splines);
}

}  // namespace hazumi::makers
