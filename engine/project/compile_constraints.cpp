#include "engine/project/compile_constraints.h"

#include <string>

#include "engine/base/named.h"
#include "engine/collision/shapes.h"
#include "engine/project/checks/constraint_checks.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/figure_fields.h"

namespace hazumi {

namespace {

class EndResolver {
 public:
  EndResolver(const ProjectConstraint& constraint, const Site& site, const Animation& animation)
      : span_(SpanOf(constraint)), site_(site), animation_(animation) {}

  ConstraintEnd Resolve(const ProjectConstraintEnd& source, const char* name) const {
    const Pose own = {RotationFromAngles(source.rotation_deg), source.offset_m};
    const Figure& figure = *animation_.figure;
    if (!source.joint.empty()) {
      const auto meant = FindJoints(figure, source.joint);
      return End(meant ? std::optional(meant->group) : std::nullopt, own);
    }
    if (source.object.empty()) return InWorld(own);
    if (const SceneObject* object = FindNamed(animation_.scene, source.object)) {
      ConstraintEnd end = InWorld(FrameOf(object->shape) * own);
      end.object = static_cast<int>(object - animation_.scene.data());
      return end;
    }
    const HeldObject& object = *FindNamed(animation_.held_objects, source.object);
    const Holder* holder = HolderDuring(object, span_, animation_, site_.Field(name));
    if (!holder) return {};
    return End(holder->joint, Pose{holder->rotation, holder->offset} * own);
  }

 private:
  static ConstraintEnd End(std::optional<GroupIndex> joint, const Pose& at) {
    return {false, joint, at.p, at.R, {}};
  }
  static ConstraintEnd InWorld(const Pose& at) { return {true, {}, at.p, at.R, {}}; }

  Span span_;
  Site site_;
  const Animation& animation_;
};

}  // namespace

void AddConstraints(const Project& project, Animation* animation, FirstError* errors) {
  const Site site = Site{"", errors}.Field("constraints");
  for (size_t i = 0; i < project.constraints.size(); ++i) {
    const ProjectConstraint& source = project.constraints[i];
    const EndResolver ends(source, site.Item(i), *animation);
    Constraint constraint;
    constraint.name = source.name;
    constraint.kind = source.kind;
    constraint.a = ends.Resolve(source.a, "a");
    constraint.b = ends.Resolve(source.b, "b");
    if (source.kind == ConstraintKind::kDistance) constraint.length = source.length_m;
    constraint.first_frame = source.first_frame;
    constraint.last_frame = source.last_frame;
    constraint.arrive_frames = source.arrive_frames.value_or(0);
    constraint.break_force = source.break_force_n;
    constraint.break_impulse = source.break_impulse_n_s;
    constraint.collides = source.collides;
    animation->constraints.push_back(std::move(constraint));
  }
}

}  // namespace hazumi
