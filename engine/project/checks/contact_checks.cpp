#include <optional>
#include <string>

#include "engine/project/checks/animation_checks.h"
#include "engine/project/checks/spans.h"

namespace hazumi {

namespace {

bool Touches(const DynamicsRegion& region) {
  return region.touches_scene && !region.moves_nothing();
}

bool TouchesAnything(const DynamicsRegion& region) {
  return (region.touches_scene || region.touches_self) && !region.moves_nothing();
}

void WarnAboutPin(const std::optional<GroupIndex>& pin, const std::string& place, Span frames,
                  const DynamicsRegion& region, const Animation& animation,
                  std::vector<Warning>* warnings) {
  if (!pin) return;
  warnings->push_back(
      {place, MessageOf(Check::kPinWhileTouching,
                        {Quoted(animation.figure->group(*pin).name), Text(frames.first),
                         Text(frames.last), Quoted(region.name)})});
}

// The pin is needed from the placement's first frame on, the landing's up to its last one.
void WarnAboutPins(const DynamicsRegion& region, const Animation& animation,
                   std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.placements.size() && region.root; ++i) {
    const PlacementSpan& placement = animation.placements[i];
    const Span all = SpanOf(placement), both = Common(all, SpanOf(region));
    if (placement.kind != PlacementKind::kGravity || both.is_empty()) continue;
    const std::string place = At("placements", i);
    if (both.first == all.first) {
      WarnAboutPin(placement.pin, place + ".pin", both, region, animation, warnings);
    }
    if (both.last == all.last) {
      WarnAboutPin(placement.landing_pin, place + ".landing_pin", both, region, animation,
                   warnings);
    }
  }
}

}  // namespace

void CheckContacts(const Animation& animation, FirstError* errors) {
  for (size_t i = 0; i < animation.regions.size(); ++i) {
    const DynamicsRegion& region = animation.regions[i];
    errors->Require(!TouchesAnything(region) || region.method == Method::kExact,
                    Check::kContactInPaper, At("regions", i) + ".contacts", {Quoted(region.name)});
  }
  for (size_t i = 0; i < animation.held_objects.size(); ++i) {
    const HeldObject& object = animation.held_objects[i];
    if (!object.touches_scene) continue;
    const std::string place = At("held_objects", i) + ".contacts";
    errors->Require(animation.solver.method == Method::kExact, Check::kObjectContactInPaper, place,
                    {Quoted(object.name)});
    errors->Require(std::holds_alternative<SphereShape>(object.shape), Check::kBoxWithContacts,
                    place, {Quoted(object.name)});
  }
}

void WarnAboutContacts(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.regions.size(); ++i) {
    const DynamicsRegion& region = animation.regions[i];
    if (!Touches(region)) continue;
    if (animation.scene.empty()) {
      warnings->push_back({At("regions", i) + ".contacts",
                           MessageOf(Check::kNothingToTouch, {Quoted(region.name)})});
    }
    WarnAboutPins(region, animation, warnings);
  }
}

}  // namespace hazumi
