#include "engine/makers/fills/limbs.h"

#include <algorithm>

#include "engine/body/figure_body.h"

namespace hazumi::makers {

namespace {

constexpr double kLight = 0.01;      // share of the figure's mass that a limb has at least
constexpr double kMost = 2.0 / 3.0;  // share of the mass beyond a joint on which a limb goes on

class LimbFinder {
 public:
  explicit LimbFinder(const Figure& figure) : figure_(figure) {
    for (const JointGroup& group : figure.groups()) {
      double mass = 0.0;
      const JointIndex end = figure.joint(group.first).subtree_end;
      for (int j = group.first.value(); j < end.value(); ++j) {
        mass += figure.body(JointIndex(j)).mass;
      }
      masses_.push_back(mass);
    }
  }

  void Find(GroupIndex group, std::vector<Limb>* limbs) const {
    if (IsLight(group)) return;
    if (NumEnds(group) <= 1) return limbs->push_back(From(group));
    for (const GroupIndex child : ChildrenOf(figure_.group(group).last(), figure_)) {
      Find(child, limbs);
    }
  }

 private:
  double MassOf(GroupIndex group) const { return masses_[static_cast<size_t>(group.value())]; }
  bool IsLight(GroupIndex group) const { return MassOf(group) < kLight * figure_.total_mass(); }

  // Number of limbs from a joint on.
  int NumEnds(GroupIndex group) const {
    int ends = 0;
    for (const GroupIndex child : ChildrenOf(figure_.group(group).last(), figure_)) {
      if (!IsLight(child)) ends += NumEnds(child);
    }
    return std::max(ends, 1);
  }

  Limb From(GroupIndex group) const {
    Limb limb = {group};
    for (;;) {
      // Go on in the part with most of the mass: the hand, not the twist bone beside it.
      const std::vector<GroupIndex> next = ChildrenOf(figure_.group(limb.back()).last(), figure_);
      double sum = 0.0;
      for (const GroupIndex child : next) sum += MassOf(child);
      const auto heavy = std::find_if(
          next.begin(), next.end(), [&](GroupIndex child) { return MassOf(child) > kMost * sum; });
      if (heavy == next.end()) return limb;
      limb.push_back(*heavy);
    }
  }

  const Figure& figure_;
  std::vector<double> masses_;  // of a joint and everything beyond it [kg]
};

}  // namespace

std::vector<Limb> LimbsOf(const Figure& figure) {
  const LimbFinder finder(figure);
  std::vector<Limb> limbs;
  for (const GroupIndex group : ChildrenOf(JointIndex(), figure)) finder.Find(group, &limbs);
  return limbs;
}

bool IsLeg(const Limb& limb, const Figure& figure) {
  const FigureBody body(figure);
  return std::any_of(limb.begin(), limb.end(), [&](GroupIndex group) {
    const BodyRole role = body.PlaceOf(group).role;
    return role == BodyRole::kThigh || role == BodyRole::kShin || role == BodyRole::kFoot;
  });
}

}  // namespace hazumi::makers
