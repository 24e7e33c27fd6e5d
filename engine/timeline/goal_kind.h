#pragma once

namespace hazumi {

// Kind of state that a goal asks for in its frame.
enum class GoalKind {
  kPose,   // joints have the angles of their keys
  kPoint,  // a point of a joint's body is in a place
};
constexpr const char* NameOf(GoalKind kind) {
  switch (kind) {
    case GoalKind::kPose:
      return "pose";
    case GoalKind::kPoint:
      return "point";
  }
  return "";
}

}  // namespace hazumi
