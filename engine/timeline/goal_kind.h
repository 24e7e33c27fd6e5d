#pragma once

namespace hazumi {

// Kind of state that a goal asks for in its frame.
enum class GoalKind {
  kPose,    // joints have the angles of their keys
  kPoint,   // a point of a joint's body is in a place
  kObject,  // an object that is let go in the frame comes down on a place
};
constexpr const char* NameOf(GoalKind kind) {
  switch (kind) {
    case GoalKind::kPose:
      return "pose";
    case GoalKind::kPoint:
      return "point";
    case GoalKind::kObject:
      return "object";
  }
  return "";
}

// Manner in which an arm throws.
enum class ThrowStyle {
  kUnderarm,  // swings forward below the shoulder
  kOverarm,   // is drawn back beside the head, and throws past it
  kPush,      // pushes away from the shoulder
};
constexpr const char* NameOf(ThrowStyle style) {
  switch (style) {
    case ThrowStyle::kUnderarm:
      return "underarm";
    case ThrowStyle::kOverarm:
      return "overarm";
    case ThrowStyle::kPush:
      return "push";
  }
  return "";
}

}  // namespace hazumi
