#pragma once

// The fields of goals; see project_fields.h.

#include "engine/project/enum_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/project/fields/field.h"
#include "engine/project/fields/scene_fields.h"
#include "engine/project/project.h"

namespace hazumi {

template <>
inline constexpr std::array kAddLabels<ProjectGoal> = {"Add pose to meet", "Add point to reach"};
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
               .help = "pose or point",
               .details = "Pose: joints have the angles of their keys. Point: a point of a joint's "
                          "body is in a place."},
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
    ar.Required({.name = "position_m",
                 .parameter = "position_?",
                 .label = "Position",
                 .help = "where the point is to be, in the world",
                 .unit = "m",
                 .step = 0.005},
                goal.position_m);
    ar.Optional({.name = "tolerance_m",
                 .parameter = "distance",
                 .label = "Distance",
                 .help = "by how much the point may miss",
                 .unit = "m",
                 .range = {1e-4, 1.0},
                 .step = 0.0005},
                goal.tolerance_m, kDefaultGoalToleranceM);
  }
  ar.Optional({.name = "rests",
               .label = "Rests",
               .help = "true: what moves there stands still in that frame"},
              goal.rests);
}

}  // namespace hazumi
