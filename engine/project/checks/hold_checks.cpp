#include <algorithm>
#include <map>
#include <utility>

#include "engine/project/checks/animation_checks.h"

// A hold needs all joints between the root and it, and moves some of them. By joint, sets of frames
// say when it is needed, moved, or needed and driven by a region, of all holds so far. Those that
// are in order do not contend for a joint, so that at any frame there are no more than joints.

namespace hazumi {

namespace {

using Joints = std::vector<JointIndex>;

bool IsAmong(const Joints& joints, JointIndex j) {
  return std::find(joints.begin(), joints.end(), j) != joints.end();
}

// A joint that a placement keeps in place.
struct Pin {
  GroupIndex joint;
  Span span;
  std::string place;
};

class HoldChecker {
 public:
  HoldChecker(const Animation& animation, const DrivenFrames& driven, const SpanSet& gravity,
              const std::atomic<bool>* cancel, FirstError* errors)
      : animation_(animation),
        figure_(*animation.figure),
        driven_(driven),
        gravity_(gravity),
        cancel_(cancel),
        errors_(errors),
        needed_(figure_.joints().size()),
        solved_(figure_.joints().size()),
        looped_(figure_.joints().size()) {
    for (const IkHold& hold : animation.holds) of_hold_.push_back(&ChainOf(hold));
    for (size_t i = 0; i < animation.placements.size(); ++i) CollectPins(i);
    std::stable_sort(pins_.begin(), pins_.end(),
                     [](const Pin& a, const Pin& b) { return a.span.first < b.span.first; });
  }

  void Check() {
    for (size_t i = 0; i < animation_.holds.size() && GoesOn(); ++i) CheckHold(i);
    for (size_t i = 0; i < animation_.holds.size() && GoesOn(); ++i) CheckFree(i);
  }

 private:
  struct Chain {
    Joints needed;  // strictly between the root and what is held
    Joints solved;  // those among them that the hold moves
  };

  bool GoesOn() const {
    return errors_->ok() && !(cancel_ && cancel_->load(std::memory_order_relaxed));
  }
  const std::string& NameOf(GroupIndex group) const { return figure_.group(group).name; }
  const std::string& GroupNameOf(JointIndex joint) const {
    return NameOf(figure_.joint(joint).group);
  }
  Span SpanOfHold(size_t i) const { return SpanOf(animation_.holds[i]); }

  // The joints strictly between the root and the group.
  const Joints& ChainTo(GroupIndex group) {
    const auto [it, is_new] = chains_to_.try_emplace(group);
    if (!is_new) return it->second;
    JointIndex j = figure_.joint(figure_.group(group).first).parent;
    for (; j.is_valid(); j = figure_.joint(j).parent) it->second.push_back(j);
    return it->second;
  }

  const Chain& ChainOf(const IkHold& hold) {
    const auto [it, is_new] = chains_.try_emplace({hold.joint, hold.reach});
    Chain& chain = it->second;
    if (!is_new) return chain;
    chain.needed = ChainTo(hold.joint);
    for (const GroupIndex g : SolvedJoints(hold, figure_)) {
      const JointGroup& group = figure_.group(g);
      for (int j = group.first.value(); j <= group.last().value(); ++j) {
        chain.solved.emplace_back(j);
      }
    }
    return chain;
  }

  JointSet SetOf(const Joints& joints) const {
    JointSet set(figure_.joints().size());
    for (const JointIndex j : joints) set[j.value()] = true;
    return set;
  }
  JointSet Needed(size_t i) const { return SetOf(of_hold_[i]->needed); }
  JointSet Solved(size_t i) const { return SetOf(of_hold_[i]->solved); }

  void CollectPins(size_t i) {
    const PlacementSpan& placement = animation_.placements[i];
    for (const auto& pin : {placement.pin, placement.landing_pin}) {
      if (pin) pins_.push_back({*pin, SpanOf(placement), At("placements", i)});
    }
  }

  void CheckHold(size_t i) {
    errors_->Require(!of_hold_[i]->needed.empty(), Check::kNothingToSolve, At("holds", i),
                     {Quoted(NameOf(animation_.holds[i].joint))});
    const bool is_in_way = Contends(i);
    for (size_t k = 0; k < i && is_in_way && errors_->ok(); ++k) CheckPair(i, k);
    CheckPins(i);
    const bool falls = gravity_.Overlaps(SpanOfHold(i));
    for (size_t k = 0; k < animation_.placements.size() && falls; ++k) CheckAgainstGravity(i, k);
    Add(i);
  }

  void Add(size_t i) {
    const Span span = SpanOfHold(i);
    for (const JointIndex j : of_hold_[i]->solved) solved_[j.value()].Add(span);
    for (const JointIndex j : of_hold_[i]->needed) {
      const auto add_loop = [&](Span both) { looped_[j.value()].Add(both); };
      needed_[j.value()].Add(span,
                             [&](Span fresh) { driven_.joint(j).ForEachCommon(fresh, add_loop); });
    }
  }

  // With a hold before it for a joint, or in a loop with it that a region swings.
  bool Contends(size_t i) const {
    const Span span = SpanOfHold(i);
    const auto is_needed = [&](JointIndex j) { return needed_[j.value()].Overlaps(span); };
    const auto is_moved = [&](JointIndex j) {
      return solved_[j.value()].Overlaps(span) || looped_[j.value()].Overlaps(span);
    };
    const Chain& chain = *of_hold_[i];
    return std::any_of(chain.needed.begin(), chain.needed.end(), is_moved) ||
           std::any_of(chain.solved.begin(), chain.solved.end(), is_needed);
  }

  void CheckPair(size_t i, size_t k) {
    const Span both = Common(SpanOfHold(i), SpanOfHold(k));
    if (both.is_empty()) return;
    const std::string one = Quoted(NameOf(animation_.holds[i].joint));
    const std::string other = Quoted(NameOf(animation_.holds[k].joint));
    if (const auto driver = driven_.FindDriver(Common(Needed(i), Needed(k)), both)) {
      return errors_->Report(Check::kLoopOfHolds, At("holds", i),
                             {driver->region, driver->joint, one, other, Text(driver->span.first),
                              Text(driver->span.last)});
    }
    const auto joint = FirstContested(i, k);
    if (!joint) return;
    errors_->Report(Check::kHoldsConflict, At("holds", i),
                    {one, other, At("holds", k), Text(both.first), Text(both.last),
                     Quoted(GroupNameOf(*joint)), OrByTheLimb(i, k)});
  }

  // The first joint that one hold moves and the other needs.
  std::optional<JointIndex> FirstContested(size_t i, size_t k) const {
    JointSet contested = Common(Solved(i), Needed(k));
    const JointSet others = Common(Solved(k), Needed(i));
    for (size_t j = 0; j < contested.size(); ++j) contested[j] = contested[j] || others[j];
    return FirstOf(contested);
  }

  // Those that are there during the hold: their spans do not overlap, so they end in order too.
  void CheckPins(size_t i) {
    const Span span = SpanOfHold(i);
    auto pin = std::partition_point(pins_.begin(), pins_.end(),
                                    [&](const Pin& p) { return p.span.last <= span.first; });
    bool is_in_way = false;
    for (; pin != pins_.end() && pin->span.first < span.last && !is_in_way; ++pin) {
      is_in_way = Contends(i, *pin);
    }
    if (!is_in_way) return;
    // In the order of the project.
    for (size_t k = 0; k < animation_.placements.size(); ++k) {
      const PlacementSpan& placement = animation_.placements[k];
      for (const auto& joint : {placement.pin, placement.landing_pin}) {
        if (joint) CheckAgainstPin(i, {*joint, SpanOf(placement), At("placements", k)});
      }
    }
  }

  bool Contends(size_t i, const Pin& pin) {
    const IkHold& hold = animation_.holds[i];
    if (hold.joint == pin.joint) return true;
    const Joints& carries = ChainTo(pin.joint);
    const Span both = Common(SpanOf(hold), pin.span);
    return std::any_of(carries.begin(), carries.end(), [&](JointIndex j) {
      return IsAmong(of_hold_[i]->solved, j) ||
             (driven_.joint(j).Overlaps(both) && IsAmong(of_hold_[i]->needed, j));
    });
  }

  void CheckAgainstPin(size_t i, const Pin& pin) {
    const IkHold& hold = animation_.holds[i];
    const Span both = Common(SpanOf(hold), pin.span);
    if (both.is_empty()) return;
    const std::string held = Quoted(NameOf(hold.joint)), pinned = Quoted(NameOf(pin.joint));
    if (hold.joint == pin.joint) {
      return errors_->Report(Check::kHoldOnPin, At("holds", i),
                             {held, pin.place, Text(both.first), Text(both.last)});
    }
    const JointSet carries = SetOf(ChainTo(pin.joint));
    if (const auto driver = driven_.FindDriver(Common(Needed(i), carries), both)) {
      return errors_->Report(Check::kLoopWithPin, At("holds", i),
                             {driver->region, driver->joint, held, pinned, Text(driver->span.first),
                              Text(driver->span.last)});
    }
    const auto joint = FirstOf(Common(Solved(i), carries));
    if (!joint) return;
    errors_->Report(Check::kHoldConflictsPin, At("holds", i),
                    {held, Quoted(GroupNameOf(*joint)), pinned, pin.place, Text(both.first),
                     Text(both.last), OrByTheLimb(i, i)});
  }

  void CheckAgainstGravity(size_t i, size_t k) {
    const PlacementSpan& placement = animation_.placements[k];
    const Span both = Common(SpanOfHold(i), SpanOf(placement));
    if (placement.kind != PlacementKind::kGravity || both.is_empty()) return;
    errors_->Report(Check::kHoldInGravity, At("holds", i),
                    {Quoted(NameOf(animation_.holds[i].joint)), At("placements", k),
                     Text(both.first), Text(both.last)});
  }

  // No region drives what the hold needs. Comes after the closed loops, whose message says more.
  void CheckFree(size_t i) {
    const IkHold& hold = animation_.holds[i];
    const Span span = SpanOf(hold);
    const bool turns = driven_.root().Overlaps(span);
    for (size_t r = 0; r < animation_.regions.size() && turns; ++r) CheckRootFree(i, r);
    const Joints& needed = of_hold_[i]->needed;
    const bool swings = std::any_of(needed.begin(), needed.end(),
                                    [&](JointIndex j) { return driven_.joint(j).Overlaps(span); });
    if (!swings) return;
    const auto driver = driven_.FindDriver(Needed(i), span);
    errors_->Report(Check::kRegionInHold, At("holds", i),
                    {driver->region, driver->joint, Quoted(NameOf(hold.joint)), At("holds", i),
                     Text(driver->span.first), Text(driver->span.last)});
  }

  // A hold is solved from where the root is.
  void CheckRootFree(size_t i, size_t r) {
    const DynamicsRegion& region = animation_.regions[r];
    const Span both = Common(SpanOf(region), SpanOfHold(i));
    if (!region.root || both.is_empty()) return;
    errors_->Report(Check::kRootInHold, At("holds", i),
                    {Quoted(region.name), Quoted(NameOf(animation_.holds[i].joint)), At("holds", i),
                     Text(both.first), Text(both.last)});
  }

  // A remedy, where one of two holds reaches with the body.
  std::string OrByTheLimb(size_t i, size_t k) const {
    const auto is_body = [&](size_t hold) {
      return animation_.holds[hold].reach == HoldReach::kBody;
    };
    return is_body(i) || is_body(k) ? " or give it the reach \"limb\"" : "";
  }

  const Animation& animation_;
  const Figure& figure_;
  const DrivenFrames& driven_;
  const SpanSet& gravity_;
  const std::atomic<bool>* cancel_;
  FirstError* errors_;
  std::map<GroupIndex, Joints> chains_to_;
  std::map<std::pair<GroupIndex, HoldReach>, Chain> chains_;
  std::vector<const Chain*> of_hold_;
  std::vector<Pin> pins_;                          // in order of time
  std::vector<SpanSet> needed_, solved_, looped_;  // by joint, of the holds checked so far
};

}  // namespace

void CheckHolds(const Animation& animation, const DrivenFrames& driven, const SpanSet& gravity,
                const std::atomic<bool>* cancel, FirstError* errors) {
  HoldChecker(animation, driven, gravity, cancel, errors).Check();
}

}  // namespace hazumi
