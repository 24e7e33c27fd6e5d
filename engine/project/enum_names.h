#pragma once

// Internal. The words that files use for enumerators. Those that the timeline names itself are its
// own; a new enumerator needs a line here all the same, so that files can say it.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/figure/figure_spec.h"
#include "engine/project/project_curve.h"
#include "engine/project/project_figure.h"
#include "engine/project/project_scene.h"
#include "engine/timeline/constraint.h"
#include "engine/timeline/dynamics_region.h"
#include "engine/timeline/fill_span.h"
#include "engine/timeline/goal_kind.h"
#include "engine/timeline/keyframe.h"
#include "engine/timeline/outer_force.h"
#include "engine/timeline/placement_span.h"

namespace hazumi {

template <typename Enum>
struct EnumName {
  Enum value;
  const char* name;
};

// Returns the words of an enumeration up to its last enumerator, as NameOf gives them.
template <auto kLast>
constexpr auto NamesUpTo() {
  using Enum = decltype(kLast);
  std::array<EnumName<Enum>, static_cast<size_t>(kLast) + 1> names = {};
  for (size_t i = 0; i < names.size(); ++i) {
    names[i] = {static_cast<Enum>(i), NameOf(static_cast<Enum>(i))};
  }
  return names;
}

// What the enumeration is called in messages, and its words in the order in which they are offered.
template <typename Enum>
struct EnumNames;

template <>
struct EnumNames<Method> {
  static constexpr const char* kWhat = "method";
  static constexpr EnumName<Method> kNames[] = {{Method::kExact, NameOf(Method::kExact)},
                                                {Method::kPaper, NameOf(Method::kPaper)}};
};

template <>
struct EnumNames<Interpolation> {
  static constexpr const char* kWhat = "interpolation";
  static constexpr EnumName<Interpolation> kNames[] = {
      {Interpolation::kHold, "hold"},
      {Interpolation::kLinear, "linear"},
      {Interpolation::kQuadratic, "quadratic"},
      {Interpolation::kCubic, "cubic"},
      {Interpolation::kLeastAcceleration, "least_acceleration"},
      {Interpolation::kLeastJerk, "least_jerk"},
      {Interpolation::kSine, "sine"},
      {Interpolation::kQuintic, "quintic"},
      {Interpolation::kExponential, "exponential"},
      {Interpolation::kBack, "back"},
      {Interpolation::kBounce, "bounce"},
      {Interpolation::kElastic, "elastic"}};
};

template <>
struct EnumNames<Easing> {
  static constexpr const char* kWhat = "easing";
  static constexpr EnumName<Easing> kNames[] = {
      {Easing::kIn, "in"}, {Easing::kOut, "out"}, {Easing::kInOut, "in_out"}};
};

template <>
struct EnumNames<KeyType> {
  static constexpr const char* kWhat = "key type";
  static constexpr EnumName<KeyType> kNames[] = {
      {KeyType::kKeyframe, "keyframe"},      {KeyType::kBreakdown, "breakdown"},
      {KeyType::kExtreme, "extreme"},        {KeyType::kJitter, "jitter"},
      {KeyType::kMovingHold, "moving_hold"}, {KeyType::kGenerated, "generated"}};
};

template <>
struct EnumNames<FillEnds> {
  static constexpr const char* kWhat = "ends of a fill";
  static constexpr EnumName<FillEnds> kNames[] = {{FillEnds::kRest, NameOf(FillEnds::kRest)},
                                                  {FillEnds::kFree, NameOf(FillEnds::kFree)}};
};

template <>
struct EnumNames<FillFrame> {
  static constexpr const char* kWhat = "frame of a fill";
  static constexpr EnumName<FillFrame> kNames[] = {{FillFrame::kWorld, NameOf(FillFrame::kWorld)},
                                                   {FillFrame::kBody, NameOf(FillFrame::kBody)}};
};

template <>
struct EnumNames<GoalKind> {
  static constexpr const char* kWhat = "kind of a goal";
  static constexpr EnumName<GoalKind> kNames[] = {{GoalKind::kPose, NameOf(GoalKind::kPose)},
                                                  {GoalKind::kPoint, NameOf(GoalKind::kPoint)},
                                                  {GoalKind::kObject, NameOf(GoalKind::kObject)}};
};

template <>
struct EnumNames<ThrowStyle> {
  static constexpr const char* kWhat = "style of a throw";
  static constexpr EnumName<ThrowStyle> kNames[] = {
      {ThrowStyle::kUnderarm, NameOf(ThrowStyle::kUnderarm)},
      {ThrowStyle::kOverarm, NameOf(ThrowStyle::kOverarm)},
      {ThrowStyle::kPush, NameOf(ThrowStyle::kPush)}};
};

template <>
struct EnumNames<ReferenceView> {
  static constexpr const char* kWhat = "view";
  static constexpr EnumName<ReferenceView> kNames[] = {{ReferenceView::kBackground, "background"},
                                                       {ReferenceView::kPlane, "plane"}};
};

template <>
struct EnumNames<DriveKind> {
  static constexpr const char* kWhat = "drive";
  static constexpr EnumName<DriveKind> kNames[] = {
      {DriveKind::kTorque, NameOf(DriveKind::kTorque)},
      {DriveKind::kKeys, NameOf(DriveKind::kKeys)},
      {DriveKind::kSpring, NameOf(DriveKind::kSpring)}};
};

template <>
struct EnumNames<SpringTarget> {
  static constexpr const char* kWhat = "spring's target";
  static constexpr EnumName<SpringTarget> kNames[] = {
      {SpringTarget::kKeys, NameOf(SpringTarget::kKeys)},
      {SpringTarget::kStart, NameOf(SpringTarget::kStart)},
      {SpringTarget::kRest, NameOf(SpringTarget::kRest)}};
};

template <>
struct EnumNames<PlacementKind> {
  static constexpr const char* kWhat = "placement kind";
  static constexpr EnumName<PlacementKind> kNames[] = {
      {PlacementKind::kPinned, NameOf(PlacementKind::kPinned)},
      {PlacementKind::kGravity, NameOf(PlacementKind::kGravity)},
      {PlacementKind::kKeyed, NameOf(PlacementKind::kKeyed)}};
};

template <>
struct EnumNames<HoldReach> {
  static constexpr const char* kWhat = "reach";
  static constexpr EnumName<HoldReach> kNames[] = {{HoldReach::kLimb, NameOf(HoldReach::kLimb)},
                                                   {HoldReach::kBody, NameOf(HoldReach::kBody)}};
};

template <>
struct EnumNames<ForceKind> {
  static constexpr const char* kWhat = "force kind";
  static constexpr auto kNames =
      NamesUpTo<static_cast<ForceKind>(std::variant_size_v<ForceAction> - 1)>();
};

template <>
struct EnumNames<ConstraintKind> {
  static constexpr const char* kWhat = "constraint kind";
  static constexpr EnumName<ConstraintKind> kNames[] = {
      {ConstraintKind::kPoint, NameOf(ConstraintKind::kPoint)},
      {ConstraintKind::kWeld, NameOf(ConstraintKind::kWeld)},
      {ConstraintKind::kDistance, NameOf(ConstraintKind::kDistance)}};
};

template <>
struct EnumNames<ShippedSkin> {
  static constexpr const char* kWhat = "skin";
  static constexpr EnumName<ShippedSkin> kNames[] = {{ShippedSkin::kHuman, "human"}};
};

template <>
struct EnumNames<Look::Shape> {
  static constexpr const char* kWhat = "shape";
  static constexpr EnumName<Look::Shape> kNames[] = {
      {Look::Shape::kTaperedCapsule, "tapered_capsule"}, {Look::Shape::kEllipsoid, "ellipsoid"}};
};

template <>
struct EnumNames<BodyRole> {
  static constexpr const char* kWhat = "role";
  static constexpr auto kNames = NamesUpTo<BodyRole::kHelper>();
};

template <>
struct EnumNames<BodySide> {
  static constexpr const char* kWhat = "side";
  static constexpr auto kNames = NamesUpTo<BodySide::kRight>();
};

// Tables have none: they are written out.
template <>
struct EnumNames<LinkSurface::Kind> {
  static constexpr const char* kWhat = "coefficients";
  static constexpr EnumName<LinkSurface::Kind> kNames[] = {{LinkSurface::Kind::kPlate, "plate"},
                                                           {LinkSurface::Kind::kWing, "wing"}};
};

template <>
struct EnumNames<StrengthCurve::Form> {
  static constexpr const char* kWhat = "curve";
  static constexpr EnumName<StrengthCurve::Form> kNames[] = {
      {StrengthCurve::Form::kConstant, "constant"},
      {StrengthCurve::Form::kCosine, "cosine"},
      {StrengthCurve::Form::kBell, "bell"}};
};

template <typename Enum>
concept FileEnum = requires {
  EnumNames<Enum>::kNames;
};
// An item whose kind decides which fields it has: a member, or what it says and can become.
template <typename T>
concept HasKindMember = requires(T item) {
  EnumNames<decltype(item.kind)>::kNames;
};
template <typename T>
concept BecomesKind = requires(T item) {
  EnumNames<decltype(item.kind())>::kNames;
  item.Become(item.kind());
};
template <typename T>
concept HasKind = HasKindMember<T> || BecomesKind<T>;

// An item of each kind, if there are kinds.
template <typename T, typename Action>
void ForEachKind(Action action) {
  T item;
  if constexpr (HasKindMember<T>) {
    for (const auto& kind : EnumNames<decltype(item.kind)>::kNames) {
      item.kind = kind.value;
      action(item, kind.name);
    }
  } else if constexpr (BecomesKind<T>) {
    for (const auto& kind : EnumNames<decltype(item.kind())>::kNames) {
      item.Become(kind.value);
      action(item, kind.name);
    }
  } else {
    action(item, "");
  }
}

template <FileEnum Enum>
const char* NameOf(Enum value) {
  for (const auto& entry : EnumNames<Enum>::kNames) {
    if (entry.value == value) return entry.name;
  }
  return "";
}

}  // namespace hazumi
