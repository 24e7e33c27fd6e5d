#include "engine/body/shape_roles.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

constexpr double kFar = 0.25;       // of the height: how far legs go down, and the trunk up
constexpr double kShort = 0.6;      // of the bone after it: a clavicle, a hip joint
constexpr double kTogether = 1e-9;  // [m]
using Chain = std::vector<size_t>;

class Shape {
 public:
  explicit Shape(std::vector<RestBone>* bones)
      : bones_(*bones), children_(bones->size()), depth_(bones->size(), 1) {
    for (size_t b = 0; b < bones_.size(); ++b) {
      low_.push_back(z(b));
      high_.push_back(z(b));
      if (bones_[b].parent >= 0) children_[static_cast<size_t>(bones_[b].parent)].push_back(b);
    }
    for (size_t b = bones_.size(); b-- > 1;) {
      if (bones_[b].parent < 0) continue;
      const auto parent = static_cast<size_t>(bones_[b].parent);
      low_[parent] = std::min(low_[parent], low_[b]);
      high_[parent] = std::max(high_[parent], high_[b]);
      depth_[parent] = std::max(depth_[parent], depth_[b] + 1);
    }
  }

  bool Set() {
    if (bones_.empty() || !FindHips() || !FindChest()) return false;
    const Vec3 along = p(trunk_.back()) - p(hips_);
    if (along.z() < along.head<2>().norm()) return false;  // an animal on four legs
    const Vec3 forward = Forward();
    const Vec3 left = Vec3::UnitZ().cross(forward);
    const BodySide first = SideOf(legs_[0], left), second = SideOf(legs_[1], left);
    const BodySide arm = SideOf(arms_[0], left), other_arm = SideOf(arms_[1], left);
    if (first == second || arm == other_arm) return false;
    for (const Chain& leg : legs_) SetLeg(leg, SideOf(leg, left));
    for (const Chain& own : arms_) SetArm(own, SideOf(own, left));
    SetTrunk();
    return true;
  }

 private:
  const Vec3& p(size_t b) const { return bones_[b].X_R.p; }
  double z(size_t b) const { return p(b).z(); }
  double height() const { return high_[0] - low_[0]; }
  double Length(const Chain& chain, size_t i) const {
    return (p(chain[i + 1]) - p(chain[i])).norm();
  }

  // From a bone out, always to the child on which most bones hang in a row.
  Chain ChainFrom(size_t b) const {
    Chain chain = {b};
    while (!children_[chain.back()].empty()) {
      const std::vector<size_t>& next = children_[chain.back()];
      chain.push_back(*std::max_element(next.begin(), next.end(),
                                        [&](size_t x, size_t y) { return depth_[x] < depth_[y]; }));
    }
    return chain;
  }

  bool FindHips() {
    for (size_t b = 0; b < bones_.size(); ++b) {
      std::vector<size_t> down, up;
      for (const size_t child : children_[b]) {
        if (low_[child] < z(b) - kFar * height()) down.push_back(child);
        if (high_[child] > z(b) + kFar * height()) up.push_back(child);
      }
      if (down.size() != 2 || up.size() != 1) continue;
      hips_ = b;
      trunk_ = {up[0]};
      for (const size_t leg : down) legs_.push_back(WithoutShort(ChainFrom(leg), 4));
      return legs_[0].size() >= 2 && legs_[1].size() >= 2 && up[0] != down[0] && up[0] != down[1];
    }
    return false;
  }

  // A hip joint above a thigh is left out.
  Chain WithoutShort(Chain chain, size_t most) const {
    if (chain.size() > most && Length(chain, 0) < kShort * Length(chain, 1))
      chain.erase(chain.begin());
    return chain;
  }

  // Up the trunk to where two arms leave it, and on to the head.
  bool FindChest() {
    while (arms_.empty()) {
      const size_t b = trunk_.back();
      if (children_[b].empty()) return false;
      const size_t up = *std::max_element(children_[b].begin(), children_[b].end(),
                                          [&](size_t x, size_t y) { return high_[x] < high_[y]; });
      std::vector<Chain> others;
      for (const size_t child : children_[b]) {
        Chain chain = ChainFrom(child);
        if (child != up && chain.size() >= 2) others.push_back(std::move(chain));
      }
      if (others.size() == 2) arms_ = std::move(others);
      if (!arms_.empty()) neck_ = ChainFrom(up);
      trunk_.push_back(up);
    }
    trunk_.pop_back();
    return true;
  }

  Vec3 Forward() const {
    Vec3 sum = Vec3::Zero();
    for (const Chain& leg : legs_) {
      const size_t foot = leg[std::min<size_t>(2, leg.size() - 1)];
      if (leg.size() > 3) sum += p(leg[3]) - p(foot);
      if (leg.size() <= 3 && bones_[foot].end) sum += *bones_[foot].end - p(foot);
    }
    sum.z() = 0.0;
    return sum.norm() > kTogether ? Vec3(sum.normalized()) : Vec3(Vec3::UnitX());
  }

  BodySide SideOf(const Chain& chain, const Vec3& left) const {
    return (p(chain[0]) - p(hips_)).dot(left) > 0.0 ? BodySide::kLeft : BodySide::kRight;
  }

  void SetLeg(const Chain& leg, BodySide side) {
    constexpr BodyRole kRoles[] = {BodyRole::kThigh, BodyRole::kShin, BodyRole::kFoot,
                                   BodyRole::kToe};
    for (size_t i = 0; i < std::min<size_t>(4, leg.size()); ++i)
      bones_[leg[i]].place = {kRoles[i], side};
  }

  void SetArm(const Chain& arm, BodySide side) {
    size_t i = 0;
    if (arm.size() >= 4 && Length(arm, 0) < kShort * Length(arm, 1)) {
      bones_[arm[i++]].place = {BodyRole::kClavicle, side};
    }
    for (const BodyRole role : {BodyRole::kUpperArm, BodyRole::kForearm, BodyRole::kHand}) {
      if (i < arm.size()) bones_[arm[i++]].place = {role, side};
    }
    if (i < arm.size()) SetFingers(arm[i - 1], side);
  }

  void SetFingers(size_t hand, BodySide side) {
    std::vector<char> is_below(bones_.size(), 0);
    is_below[hand] = 1;
    for (size_t b = hand + 1; b < bones_.size(); ++b) {
      if (bones_[b].parent < 0 || !is_below[static_cast<size_t>(bones_[b].parent)]) continue;
      is_below[b] = 1;
      bones_[b].place = {BodyRole::kFinger, side};
    }
  }

  void SetTrunk() {
    bones_[hips_].place = {BodyRole::kHips, BodySide::kMiddle};
    for (const size_t b : trunk_) bones_[b].place = {BodyRole::kSpine, BodySide::kMiddle};
    const size_t head = neck_.size() >= 2 ? 1 : 0;
    if (head > 0) bones_[neck_[0]].place = {BodyRole::kNeck, BodySide::kMiddle};
    bones_[neck_[head]].place = {BodyRole::kHead, BodySide::kMiddle};
  }

  std::vector<RestBone>& bones_;
  std::vector<std::vector<size_t>> children_;
  std::vector<double> low_, high_;  // by bone: of it and of all below it [m]
  std::vector<int> depth_;          // by bone: bones in a row from it on
  size_t hips_ = 0;
  Chain trunk_, neck_;  // from above the hips to the chest; from there to the head
  std::vector<Chain> legs_, arms_;
};

}  // namespace

bool SetRolesByShape(std::vector<RestBone>* bones) { return Shape(bones).Set(); }

}  // namespace hazumi
