#include "engine/project/compile_checks.h"

#include <algorithm>

namespace hazumi {

namespace {

// Half open, so that spans may touch.
struct Span {
  int first, last;
  bool is_empty() const { return first >= last; }
};

template <typename Item>
Span SpanOf(const Item& item) {
  return {item.first_frame, item.last_frame};
}

Span Common(Span a, Span b) { return {std::max(a.first, b.first), std::min(a.last, b.last)}; }

using JointSet = std::vector<bool>;  // by JointIndex

JointSet Common(const JointSet& a, const JointSet& b) {
  JointSet both(a.size());
  for (size_t j = 0; j < a.size(); ++j) both[j] = a[j] && b[j];
  return both;
}

JointSet Either(const JointSet& a, const JointSet& b) {
  JointSet either(a.size());
  for (size_t j = 0; j < a.size(); ++j) either[j] = a[j] || b[j];
  return either;
}

std::optional<JointIndex> FirstOf(const JointSet& set) {
  const auto it = std::find(set.begin(), set.end(), true);
  if (it == set.end()) return std::nullopt;
  return JointIndex(static_cast<int>(it - set.begin()));
}

std::string At(const char* list, size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

std::string Text(int number) { return std::to_string(number); }

// A joint that a placement keeps in place.
struct Pin {
  GroupIndex joint;
  Span span;
  std::string place;
};

class AnimationChecker {
 public:
  AnimationChecker(const Animation& animation, FirstError* errors)
      : animation_(animation), figure_(*animation.figure), errors_(errors) {
    for (const DynamicsRegion& region : animation.regions) driven_.push_back(JointsOf(region));
    for (const IkHold& hold : animation.holds) {
      needed_.push_back(ChainTo(hold.joint));
      solved_.push_back(SolvedBy(hold));
    }
    for (size_t i = 0; i < animation.placements.size(); ++i) CollectPins(i);
  }

  void Check() {
    CheckWithinFrames(animation_.regions, "regions");
    CheckWithinFrames(animation_.placements, "placements");
    CheckWithinFrames(animation_.holds, "holds");
    CheckReleases();
    CheckPlacements();
    for (size_t i = 0; i < animation_.regions.size(); ++i) CheckRegion(i);
    for (size_t i = 0; i < animation_.holds.size(); ++i) CheckHold(i);
    for (size_t i = 0; i < animation_.holds.size(); ++i) CheckFree(i);
  }

 private:
  const std::string& NameOf(GroupIndex group) const { return figure_.group(group).name; }
  const std::string& GroupNameOf(JointIndex joint) const {
    return NameOf(figure_.joint(joint).group);
  }

  JointSet JointsOf(const DynamicsRegion& region) const {
    JointSet set(figure_.joints().size());
    for (JointIndex joint : region.joints) set[joint.value()] = true;
    return set;
  }

  // The joints strictly between the root and the group.
  JointSet ChainTo(GroupIndex group) const {
    JointSet chain(figure_.joints().size());
    JointIndex j = figure_.joint(figure_.group(group).first).parent;
    for (; j.is_valid(); j = figure_.joint(j).parent) chain[j.value()] = true;
    return chain;
  }

  JointSet SolvedBy(const IkHold& hold) const {
    JointSet solved(figure_.joints().size());
    for (const GroupIndex g : SolvedJoints(hold, figure_)) {
      const JointGroup& group = figure_.group(g);
      for (int j = group.first.value(); j <= group.last().value(); ++j) solved[j] = true;
    }
    return solved;
  }

  void CollectPins(size_t i) {
    const PlacementSpan& placement = animation_.placements[i];
    for (const auto& pin : {placement.pin, placement.landing_pin}) {
      if (pin) pins_.push_back({*pin, SpanOf(placement), At("placements", i)});
    }
  }

  template <typename Items>
  void CheckWithinFrames(const Items& items, const char* list) {
    for (size_t i = 0; i < items.size(); ++i) {
      const Span span = SpanOf(items[i]);
      const bool good = span.first >= animation_.first_frame && span.last <= animation_.last_frame;
      errors_->Require(good, Check::kOutsideFrames, At(list, i),
                       {Text(span.first), Text(span.last), Text(animation_.first_frame),
                        Text(animation_.last_frame)});
    }
  }

  void CheckReleases() {
    for (size_t i = 0; i < animation_.held_objects.size(); ++i) {
      const int frame = animation_.held_objects[i].release_frame.value_or(animation_.first_frame);
      const bool good = frame >= animation_.first_frame && frame <= animation_.last_frame;
      errors_->Require(good, Check::kReleaseOutside, At("held_objects", i) + ".release_frame",
                       {Text(frame), Text(animation_.first_frame), Text(animation_.last_frame)});
    }
  }

  void CheckPlacements() {
    const auto& placements = animation_.placements;
    for (size_t i = 0; i < placements.size(); ++i) {
      for (size_t k = 0; k < i; ++k) {
        const Span both = Common(SpanOf(placements[i]), SpanOf(placements[k]));
        errors_->Require(both.is_empty(), Check::kPlacementsOverlap, At("placements", i),
                         {Text(static_cast<int>(k)), Text(both.first), Text(both.last)});
      }
    }
  }

  void CheckRegion(size_t i) {
    const DynamicsRegion& region = animation_.regions[i];
    errors_->Require(region.root || !region.joints.empty(), Check::kRegionAllFixed,
                     At("regions", i) + ".joints", {Quoted(region.name)});
    for (size_t k = 0; k < i; ++k) CheckRegions(i, k);
    for (size_t k = 0; k < animation_.placements.size(); ++k) CheckMethodInGravity(i, k);
  }

  // Regions may share frames but nothing that they drive, and are then solved together.
  void CheckRegions(size_t i, size_t k) {
    const DynamicsRegion &region = animation_.regions[i], &other = animation_.regions[k];
    const Span both = Common(SpanOf(region), SpanOf(other));
    if (both.is_empty()) return;
    if (const auto shared = SharedBy(i, k)) {
      errors_->Report(
          Check::kRegionsOverlap, At("regions", i),
          {Quoted(other.name), Quoted(region.name), *shared, Text(both.first), Text(both.last)});
    }
    errors_->Require(region.method == other.method, Check::kMethodsDiffer, At("regions", i),
                     {Quoted(other.name), Quoted(region.name), Text(both.first), Text(both.last),
                      Quoted(hazumi::NameOf(other.method)), Quoted(hazumi::NameOf(region.method))});
  }

  // What both regions drive, for a message.
  std::optional<std::string> SharedBy(size_t i, size_t k) const {
    if (const auto joint = FirstOf(Common(driven_[i], driven_[k]))) {
      return Quoted(figure_.joint(*joint).name);
    }
    if (animation_.regions[i].root && animation_.regions[k].root) return "the root";
    return std::nullopt;
  }

  // The fall and what swings in it depend on each other, so they are solved together.
  void CheckMethodInGravity(size_t i, size_t k) {
    const DynamicsRegion& region = animation_.regions[i];
    const PlacementSpan& placement = animation_.placements[k];
    const Span both = Common(SpanOf(region), SpanOf(placement));
    const Method method = animation_.solver.method;
    if (placement.kind != PlacementKind::kGravity || both.is_empty()) return;
    errors_->Require(region.method == method, Check::kMethodInGravity, At("regions", i),
                     {Quoted(region.name), Quoted(hazumi::NameOf(region.method)), Text(both.first),
                      Text(both.last), At("placements", k), Quoted(hazumi::NameOf(method))});
  }

  // A region that drives one of the joints during the span.
  struct Driver {
    std::string region, joint;
    Span span;
  };
  std::optional<Driver> FindDriver(const JointSet& joints, Span span) const {
    for (size_t r = 0; r < animation_.regions.size(); ++r) {
      const DynamicsRegion& region = animation_.regions[r];
      const Span both = Common(SpanOf(region), span);
      const auto joint = FirstOf(Common(driven_[r], joints));
      if (both.is_empty() || !joint) continue;
      return Driver{Quoted(region.name), Quoted(figure_.joint(*joint).name), both};
    }
    return std::nullopt;
  }

  void CheckHold(size_t i) {
    errors_->Require(FirstOf(needed_[i]).has_value(), Check::kNothingToSolve, At("holds", i),
                     {Quoted(NameOf(animation_.holds[i].joint))});
    for (size_t k = 0; k < i; ++k) CheckPair(i, k);
    for (const Pin& pin : pins_) CheckAgainstPin(i, pin);
    for (size_t k = 0; k < animation_.placements.size(); ++k) CheckAgainstGravity(i, k);
  }

  void CheckAgainstGravity(size_t i, size_t k) {
    const PlacementSpan& placement = animation_.placements[k];
    const Span both = Common(SpanOf(animation_.holds[i]), SpanOf(placement));
    if (placement.kind != PlacementKind::kGravity || both.is_empty()) return;
    errors_->Report(Check::kHoldInGravity, At("holds", i),
                    {Quoted(NameOf(animation_.holds[i].joint)), At("placements", k),
                     Text(both.first), Text(both.last)});
  }

  // No region drives what the hold needs. Comes after the closed loops, whose message says more.
  void CheckFree(size_t i) {
    const IkHold& hold = animation_.holds[i];
    for (const DynamicsRegion& region : animation_.regions) CheckRootFree(i, region);
    const auto driver = FindDriver(needed_[i], SpanOf(hold));
    if (!driver) return;
    errors_->Report(Check::kRegionInHold, At("holds", i),
                    {driver->region, driver->joint, Quoted(NameOf(hold.joint)), At("holds", i),
                     Text(driver->span.first), Text(driver->span.last)});
  }

  // A hold is solved from where the root is.
  void CheckRootFree(size_t i, const DynamicsRegion& region) {
    const IkHold& hold = animation_.holds[i];
    const Span both = Common(SpanOf(region), SpanOf(hold));
    if (!region.root || both.is_empty()) return;
    errors_->Report(Check::kRootInHold, At("holds", i),
                    {Quoted(region.name), Quoted(NameOf(hold.joint)), At("holds", i),
                     Text(both.first), Text(both.last)});
  }

  void CheckPair(size_t i, size_t k) {
    const Span both = Common(SpanOf(animation_.holds[i]), SpanOf(animation_.holds[k]));
    if (both.is_empty()) return;
    const std::string one = Quoted(NameOf(animation_.holds[i].joint));
    const std::string other = Quoted(NameOf(animation_.holds[k].joint));
    if (const auto driver = FindDriver(Common(needed_[i], needed_[k]), both)) {
      return errors_->Report(Check::kLoopOfHolds, At("holds", i),
                             {driver->region, driver->joint, one, other, Text(driver->span.first),
                              Text(driver->span.last)});
    }
    const JointSet contested =
        Either(Common(solved_[i], needed_[k]), Common(solved_[k], needed_[i]));
    const auto joint = FirstOf(contested);
    if (!joint) return;
    errors_->Report(Check::kHoldsConflict, At("holds", i),
                    {one, other, At("holds", k), Text(both.first), Text(both.last),
                     Quoted(GroupNameOf(*joint)), OrByTheLimb(i, k)});
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
    const JointSet carries = ChainTo(pin.joint);
    if (const auto driver = FindDriver(Common(needed_[i], carries), both)) {
      return errors_->Report(Check::kLoopWithPin, At("holds", i),
                             {driver->region, driver->joint, held, pinned, Text(driver->span.first),
                              Text(driver->span.last)});
    }
    const auto joint = FirstOf(Common(solved_[i], carries));
    if (!joint) return;
    errors_->Report(Check::kHoldConflictsPin, At("holds", i),
                    {held, Quoted(GroupNameOf(*joint)), pinned, pin.place, Text(both.first),
                     Text(both.last), OrByTheLimb(i, i)});
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
  FirstError* errors_;
  std::vector<JointSet> driven_;  // by region
  std::vector<JointSet> needed_;  // by hold: the joints that it depends on
  std::vector<JointSet> solved_;  // by hold: those among them that it moves
  std::vector<Pin> pins_;
};

}  // namespace

void CheckAnimation(const Animation& animation, FirstError* errors) {
  AnimationChecker(animation, errors).Check();
}

void WarnAboutPlacements(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.placements.size() && animation.scene.empty(); ++i) {
    if (animation.placements[i].kind != PlacementKind::kGravity) continue;
    warnings->push_back({At("placements", i), MessageOf(Check::kNothingToLandOn, {})});
  }
}

}  // namespace hazumi
