#pragma once

// The fields of goals; see project_fields.h.

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

template <>
inline constexpr std::array kAddLabels<ProjectGoal> = {"Add pose to meet", "Add point to reach",
                                                       "Add spot to throw onto"};
template <>
inline constexpr StructInfo kStructInfo<ProjectGoal> = {
    "goal",
    "What has to come true in a frame while a dynamics region moves the joints. A goal by itself "
    "moves nothing: goal.aim finds torques for the region's limp joints with which it comes true, "
    "and writes them as drives."};
template <typename Ar>
void Describe(Ar& ar, Ref<Ar, ProjectGoal> goal) {
  ar.Required(kNameField, goal.name);
  ar.Required({.name = "kind",
               .label = "Kind",
               .help = "pose, point or object",
               .details = "Pose: joints have the angles of their keys. Point: a point of a joint's "
                          "body is in a place. Object: what a hand lets go in that frame comes "
                          "down on a place."},
              goal.kind);
  ar.Required({.name = "frame", .label = "Frame", .help = "the frame in which it comes true"},
              goal.frame);
  if (goal.kind == GoalKind::kPose) {
    ar.Required({.name = "joints",
                 .label = "Joints",
                 .help = "joints that have the angles of their keys there",
                 .details = "A joint, or with + everything beyond it. Nothing is asked of "
                            "joints that no region leaves limp there.",
                 .thing = Thing::kJoint,
                 .is_filled = true},
                goal.joints);
    ar.Optional({.name = "tolerance_deg",
                 .parameter = "tolerance",
                 .label = "Tolerance",
                 .help = "by how much an angle may miss",
                 .unit = "°",
                 .range = {1e-3, 45.0}},
                goal.tolerance_deg, kDefaultGoalToleranceDeg);
  }
  if (goal.kind == GoalKind::kPoint) {
    ar.Required({.name = "joint",
                 .label = "Joint",
                 .help = "the joint on whose body the point is",
                 .thing = Thing::kJoint,
                 .is_filled = true},
                goal.joint);
    ar.Optional({.name = "offset_m",
                 .parameter = "offset_?",
                 .label = "Offset",
                 .help = "of the point, in the joint's frame",
                 .unit = "m",
                 .step = 0.005},
                goal.offset_m, Vec3(Vec3::Zero()));
  }
  if (goal.kind == GoalKind::kObject) {
    ar.Required({.name = "object",
                 .label = "Object",
                 .help = "the held object that is let go in that frame",
                 .thing = Thing::kHeldObject,
                 .is_filled = true},
                goal.object);
    ar.Optional({.name = "style",
                 .label = "Style",
                 .help = "underarm, overarm or push",
                 .details = "Underarm: the arm swings forward below the shoulder. Overarm: it is "
                            "drawn back beside the head. Push: it pushes away from the shoulder."},
                goal.style, ThrowStyle::kUnderarm);
    ar.Optional({.name = "height_m",
                 .parameter = "height",
                 .label = "Rise",
                 .help = "how far the object rises above the hand",
                 .details = "Not given: as far as it does with the least speed.",
                 .unit = "m",
                 .range = {1e-3, 100.0},
                 .step = 0.01},
                goal.height_m);
  }
  if (goal.kind != GoalKind::kPose) {
    ar.Required({.name = "position_m",
                 .parameter = "position_?",
                 .label = "Position",
                 .help = "where the point, or the object's centre, is to be, in the world",
                 .unit = "m",
                 .step = 0.005},
                goal.position_m);
    ar.Optional({.name = "tolerance_m",
                 .parameter = "distance",
                 .label = "Distance",
                 .help = "by how much it may miss the position",
                 .unit = "m",
                 .range = {1e-4, 1.0},
                 .step = 0.0005},
                goal.tolerance_m, kDefaultGoalToleranceM);
  }
  if (goal.kind == GoalKind::kObject) return;
  ar.Optional({.name = "rests",
               .label = "Rests",
               .help = "true: what moves there stands still in that frame"},
              goal.rests);
}

}  // namespace hazumi
