#include "engine/project/checks/animation_checks.h"

#include <algorithm>

#include "engine/project/checks/constraint_checks.h"

// What may not be at the same time is looked up in sets of the frames that those before take. Where
// one is in the way, which one it is is looked for among all of them: that ends the checks.

namespace hazumi {

namespace {

class AnimationChecker {
 public:
  AnimationChecker(const Animation& animation, const std::atomic<bool>* cancel, FirstError* errors)
      : animation_(animation),
        figure_(*animation.figure),
        cancel_(cancel),
        errors_(errors),
        driven_(animation) {}

  void Check() {
    CheckWithinFrames(animation_.regions, "regions");
    CheckWithinFrames(animation_.placements, "placements");
    CheckWithinFrames(animation_.holds, "holds");
    CheckHeldObjects();
    for (size_t i = 0; i < animation_.placements.size() && GoesOn(); ++i) CheckPlacement(i);
    for (size_t i = 0; i < animation_.regions.size() && GoesOn(); ++i) CheckRegion(i);
    if (GoesOn()) CheckHolds(animation_, driven_, gravity_, cancel_, errors_);
    if (GoesOn()) CheckForces(animation_, errors_);
    if (GoesOn()) CheckConstraints(animation_, errors_);
    if (GoesOn()) CheckContacts(animation_, errors_);
  }

 private:
  bool GoesOn() const {
    return errors_->ok() && !(cancel_ && cancel_->load(std::memory_order_relaxed));
  }

  template <typename Items>
  void CheckWithinFrames(const Items& items, const char* list) {
    for (size_t i = 0; i < items.size() && GoesOn(); ++i) {
      const Span span = SpanOf(items[i]);
      if (span.first >= animation_.first_frame && span.last <= animation_.last_frame) continue;
      errors_->Report(Check::kOutsideFrames, At(list, i),
                      {Text(span.first), Text(span.last), Text(animation_.first_frame),
                       Text(animation_.last_frame)});
    }
  }

  void CheckHeldObjects() {
    for (size_t i = 0; i < animation_.held_objects.size() && GoesOn(); ++i) {
      const HeldObject& object = animation_.held_objects[i];
      size_t later = 0;  // holders that are in the file's list of them
      for (const Holder& holder : object.holders) {
        const bool is_first = holder.first_frame == Holder::kFromTheStart;
        const std::string list = At("held_objects", i);
        const std::string place = is_first ? list : At((list + ".holders").c_str(), later++);
        if (!is_first) CheckWithin(holder.first_frame, place + ".first_frame");
        if (!holder.last_frame) continue;
        CheckWithin(*holder.last_frame, place + (is_first ? ".release_frame" : ".last_frame"));
      }
      const bool is_placed =
          !object.keys[0].empty() ||
          (!object.holders.empty() && object.holders[0].first_frame <= animation_.first_frame);
      errors_->Require(is_placed, Check::kPlacedByNobody, At("held_objects", i),
                       {Quoted(object.name), Text(animation_.first_frame)});
    }
  }

  void CheckWithin(int frame, const std::string& place) {
    const bool good = frame >= animation_.first_frame && frame <= animation_.last_frame;
    errors_->Require(good, Check::kReleaseOutside, place,
                     {Text(frame), Text(animation_.first_frame), Text(animation_.last_frame)});
  }

  void CheckPlacement(size_t i) {
    const auto& placements = animation_.placements;
    const Span span = SpanOf(placements[i]);
    for (size_t k = 0; k < i && placed_.Overlaps(span); ++k) {
      const Span both = Common(span, SpanOf(placements[k]));
      if (both.is_empty()) continue;
      return errors_->Report(Check::kPlacementsOverlap, At("placements", i),
                             {Text(static_cast<int>(k)), Text(both.first), Text(both.last)});
    }
    placed_.Add(span);
    if (placements[i].kind == PlacementKind::kGravity) gravity_.Add(span);
  }

  void CheckRegion(size_t i) {
    const DynamicsRegion& region = animation_.regions[i];
    if (region.is_muted) return;
    errors_->Require(!region.moves_nothing() || !region.keyed.empty(), Check::kRegionAllFixed,
                     At("regions", i) + ".joints", {Quoted(region.name)});
    CheckDrives(animation_, i, errors_);
    const bool is_in_way =
        driven_.Clashes(region) || OtherThan(region.method).Overlaps(SpanOf(region));
    for (size_t k = 0; k < i && is_in_way && errors_->ok(); ++k) CheckRegions(i, k);
    const bool falls =
        region.method != animation_.solver.method && gravity_.Overlaps(SpanOf(region));
    for (size_t k = 0; k < animation_.placements.size() && falls; ++k) CheckMethodInGravity(i, k);
    driven_.Add(region);
    (region.method == Method::kPaper ? paper_ : exact_).Add(SpanOf(region));
  }

  // Frames of regions of the other method.
  const SpanSet& OtherThan(Method method) const {
    return method == Method::kPaper ? exact_ : paper_;
  }

  // Regions may share frames but nothing that they drive, and are then solved together.
  void CheckRegions(size_t i, size_t k) {
    const DynamicsRegion &region = animation_.regions[i], &other = animation_.regions[k];
    const Span both = Common(SpanOf(region), SpanOf(other));
    if (both.is_empty() || other.is_muted) return;
    if (const auto shared = SharedBy(region, other)) {
      errors_->Report(
          Check::kRegionsOverlap, At("regions", i),
          {Quoted(other.name), Quoted(region.name), *shared, Text(both.first), Text(both.last)});
    }
    errors_->Require(region.method == other.method, Check::kMethodsDiffer, At("regions", i),
                     {Quoted(other.name), Quoted(region.name), Text(both.first), Text(both.last),
                      Quoted(NameOf(other.method)), Quoted(NameOf(region.method))});
  }

  // What both regions drive, for a message.
  std::optional<std::string> SharedBy(const DynamicsRegion& a, const DynamicsRegion& b) const {
    if (const auto joint = FirstOf(Common(JointsOf(a, figure_), JointsOf(b, figure_)))) {
      return Quoted(figure_.joint(*joint).name);
    }
    if (a.root && b.root) return "the root";
    return std::nullopt;
  }

  // The fall and what swings in it depend on each other, so they are solved together.
  void CheckMethodInGravity(size_t i, size_t k) {
    const DynamicsRegion& region = animation_.regions[i];
    const PlacementSpan& placement = animation_.placements[k];
    const Span both = Common(SpanOf(region), SpanOf(placement));
    if (placement.kind != PlacementKind::kGravity || both.is_empty()) return;
    errors_->Report(
        Check::kMethodInGravity, At("regions", i),
        {Quoted(region.name), Quoted(NameOf(region.method)), Text(both.first), Text(both.last),
         At("placements", k), Quoted(NameOf(animation_.solver.method))});
  }

  const Animation& animation_;
  const Figure& figure_;
  const std::atomic<bool>* cancel_;
  FirstError* errors_;
  // Of those checked so far.
  SpanSet placed_, gravity_, paper_, exact_;
  DrivenFrames driven_;
};

}  // namespace

std::string At(const char* list, size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void CheckAnimation(const Animation& animation, const std::atomic<bool>* cancel,
                    FirstError* errors) {
  AnimationChecker(animation, cancel, errors).Check();
}

void WarnAboutPlacements(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.placements.size() && animation.scene.empty(); ++i) {
    if (animation.placements[i].kind != PlacementKind::kGravity) continue;
    warnings->push_back({At("placements", i), MessageOf(Check::kNothingToLandOn, {})});
  }
}

}  // namespace hazumi
