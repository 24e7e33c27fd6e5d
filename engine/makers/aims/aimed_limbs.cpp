#include "engine/makers/aims/aimed_limbs.h"

#include <algorithm>

namespace hazumi::makers {

namespace {

// One vector after the other.
VecX Joined(const std::vector<const VecX*>& parts) {
  std::vector<double> all;
  for (const VecX* part : parts) all.insert(all.end(), part->data(), part->data() + part->size());
  return Eigen::Map<const VecX>(all.data(), static_cast<int>(all.size()));
}

}  // namespace

VecX AimedLimbs::Solve(const LimbWay& way) {
  std::vector<const VecX*> torques;
  for (const auto& limb : limbs_) {
    limb->Solve(way);
    torques.push_back(&limb->torques());
  }
  return Joined(torques);
}

int AimedLimbs::iterations() const {
  int count = 0;
  for (const auto& limb : limbs_) count += limb->iterations();
  return count;
}

VecX AimedLimbs::Strengths() const {
  std::vector<const VecX*> strengths;
  strengths.reserve(limbs_.size());
  for (const auto& limb : limbs_) strengths.push_back(&limb->strengths());
  return Joined(strengths);
}

MatX AimedLimbs::ChangeOf(int frame, bool is_rate) const {
  int total = 0;
  for (const auto& limb : limbs_) total += static_cast<int>(limb->torques().size());
  MatX all = MatX::Zero(figure_.num_joints(), total);
  int at = 0;
  for (const auto& limb : limbs_) {
    const int count = static_cast<int>(limb->torques().size());
    if (frame <= limb->knots().back()) {
      const MatX change = is_rate ? limb->RateChange(frame) : limb->AngleChange(frame);
      for (size_t k = 0; k < limb->hinges().path.size(); ++k) {
        all.block(limb->hinges().path[k].value(), at, 1, count) = change.row(static_cast<int>(k));
      }
    }
    at += count;
  }
  return all;
}

std::vector<int> AimedLimbs::TorquesBefore(int frame, int behind, int keys) const {
  std::vector<int> numbers;
  int at = 0;
  for (const auto& limb : limbs_) {
    const auto& knots = limb->knots();
    const int count =
        static_cast<int>(std::upper_bound(knots.begin(), knots.end(), frame) - knots.begin());
    const int end = at + static_cast<int>(limb->torques().size());
    for (; at < end; at += static_cast<int>(knots.size())) {
      for (int k = std::max(0, count - keys); k < count && frame <= knots.back(); ++k) {
        if (knots[static_cast<size_t>(k)] > behind) numbers.push_back(at + k);
      }
    }
  }
  return numbers;
}

double AimedLimbs::DepthIn(const Motion& motion) const {
  double depth = 0.0;
  for (const auto& limb : limbs_) depth = std::max(depth, limb->DepthIn(motion));
  return depth;
}

}  // namespace hazumi::makers
