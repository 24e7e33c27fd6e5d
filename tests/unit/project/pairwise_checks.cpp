#include "tests/unit/project/pairwise_checks.h"

#include <algorithm>
#include <set>

namespace hazumi::testing {

namespace {

using Joints = std::set<int>;

Joints Common(const Joints& a, const Joints& b) {
  Joints both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

// All frames of all of them are the same ones.
template <typename... Items>
bool Meet(const Items&... items) {
  return std::max({items.first_frame...}) < std::min({items.last_frame...});
}

Joints JointsOf(const DynamicsRegion& region) {
  Joints joints;
  for (const JointIndex j : region.joints) joints.insert(j.value());
  return joints;
}

class Pairwise {
 public:
  explicit Pairwise(const Animation& animation) : a_(animation), figure_(*animation.figure) {}

  std::optional<Contradiction> First() {
    for (size_t i = 0; i < a_.placements.size(); ++i) CheckPlacement(i);
    for (size_t i = 0; i < a_.regions.size(); ++i) CheckRegion(i);
    for (size_t i = 0; i < a_.holds.size(); ++i) CheckHold(i);
    for (size_t i = 0; i < a_.holds.size(); ++i) CheckFree(i);
    return first_;
  }

 private:
  void Report(bool wrong, Check check, const char* list, size_t i) {
    if (wrong && !first_) first_ = {check, list + ("[" + std::to_string(i) + "]")};
  }

  void CheckPlacement(size_t i) {
    for (size_t k = 0; k < i; ++k) {
      Report(Meet(a_.placements[i], a_.placements[k]), Check::kPlacementsOverlap, "placements", i);
    }
  }

  void CheckRegion(size_t i) {
    const DynamicsRegion& region = a_.regions[i];
    for (size_t k = 0; k < i; ++k) {
      const DynamicsRegion& other = a_.regions[k];
      const bool share = !Common(JointsOf(region), JointsOf(other)).empty();
      const bool meet = Meet(region, other);
      Report(meet && (share || (region.root && other.root)), Check::kRegionsOverlap, "regions", i);
      Report(meet && region.method != other.method, Check::kMethodsDiffer, "regions", i);
    }
    for (const PlacementSpan& span : a_.placements) {
      const bool falls = span.kind == PlacementKind::kGravity && Meet(region, span);
      Report(falls && region.method != a_.solver.method, Check::kMethodInGravity, "regions", i);
    }
  }

  Joints ChainTo(GroupIndex group) const {
    Joints chain;
    JointIndex j = figure_.joint(figure_.group(group).first).parent;
    for (; j.is_valid(); j = figure_.joint(j).parent) chain.insert(j.value());
    return chain;
  }
  Joints Needed(const IkHold& hold) const { return ChainTo(hold.joint); }
  Joints Solved(const IkHold& hold) const {
    Joints solved;
    for (const GroupIndex g : SolvedJoints(hold, figure_)) {
      const JointGroup& group = figure_.group(g);
      for (int j = group.first.value(); j <= group.last().value(); ++j) solved.insert(j);
    }
    return solved;
  }

  template <typename... Spans>
  bool Swings(const Joints& joints, const Spans&... spans) const {
    return std::any_of(a_.regions.begin(), a_.regions.end(), [&](const DynamicsRegion& region) {
      return Meet(region, spans...) && !Common(JointsOf(region), joints).empty();
    });
  }

  void CheckHold(size_t i) {
    const IkHold& hold = a_.holds[i];
    Report(Needed(hold).empty(), Check::kNothingToSolve, "holds", i);
    for (size_t k = 0; k < i; ++k) {
      const IkHold& other = a_.holds[k];
      if (!Meet(hold, other)) continue;
      Report(Swings(Common(Needed(hold), Needed(other)), hold, other), Check::kLoopOfHolds, "holds",
             i);
      const bool contend = !Common(Solved(hold), Needed(other)).empty() ||
                           !Common(Solved(other), Needed(hold)).empty();
      Report(contend, Check::kHoldsConflict, "holds", i);
    }
    for (const PlacementSpan& span : a_.placements) {
      for (const auto& pin : {span.pin, span.landing_pin}) {
        if (pin && Meet(hold, span)) CheckPin(i, *pin, span);
      }
    }
    for (const PlacementSpan& span : a_.placements) {
      Report(span.kind == PlacementKind::kGravity && Meet(hold, span), Check::kHoldInGravity,
             "holds", i);
    }
  }

  void CheckPin(size_t i, GroupIndex pin, const PlacementSpan& span) {
    const IkHold& hold = a_.holds[i];
    if (hold.joint == pin) return Report(true, Check::kHoldOnPin, "holds", i);
    const Joints carries = ChainTo(pin);
    Report(Swings(Common(Needed(hold), carries), hold, span), Check::kLoopWithPin, "holds", i);
    Report(!Common(Solved(hold), carries).empty(), Check::kHoldConflictsPin, "holds", i);
  }

  void CheckFree(size_t i) {
    const IkHold& hold = a_.holds[i];
    for (const DynamicsRegion& region : a_.regions) {
      Report(region.root && Meet(region, hold), Check::kRootInHold, "holds", i);
    }
    Report(Swings(Needed(hold), hold), Check::kRegionInHold, "holds", i);
  }

  const Animation& a_;
  const Figure& figure_;
  std::optional<Contradiction> first_;
};

}  // namespace

std::optional<Contradiction> FirstContradiction(const Animation& animation) {
  return Pairwise(animation).First();
}

}  // namespace hazumi::testing
