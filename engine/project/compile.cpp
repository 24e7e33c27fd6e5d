#include "engine/project/compile.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/figure/figure_builder.h"
#include "engine/project/checks/animation_checks.h"
#include "engine/project/checks/constraint_checks.h"
#include "engine/project/checks/document_checks.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/compile_constraints.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/figure_fields.h"
#include "engine/project/items.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

Obstacle ToObstacle(const ProjectPlane& plane) {
  return Plane{plane.normal.normalized(), plane.offset_m};
}
Obstacle ToObstacle(const ProjectBox& box) {
  return Box{{RotationFromAngles(box.rotation_deg), box.center_m}, 0.5 * box.size_m};
}

std::variant<SphereShape, BoxShape> ToShape(const ProjectSphereShape& sphere) {
  return SphereShape{sphere.radius_m};
}
std::variant<SphereShape, BoxShape> ToShape(const ProjectBoxShape& box) {
  return BoxShape{0.5 * box.size_m};
}

Error InFigure(Error error) {
  error.place = error.place.empty() ? "figure" : "figure." + error.place;
  return error;
}

double RoundedDegrees(double radians) { return std::round(radians / kDegree * 1e6) / 1e6; }

// Builds the animation from a project whose values and names have been checked.
class Compiler {
 public:
  Compiler(const Project& project, std::shared_ptr<const Figure> figure,
           const std::atomic<bool>* cancel)
      : project_(project),
        cancel_(cancel),
        figure_(std::move(figure)),
        warnings_(project.read.warnings) {}

  Result<Compiled> Compile() {
    FirstError errors;
    AddSettings();
    AddCurves();
    AddScene();
    for (size_t i = 0; i < project_.regions.size() && !is_cancelled(); ++i) AddRegion(i);
    for (const ProjectPlacement& placement : project_.placements) AddPlacement(placement);
    for (const ProjectHold& hold : project_.holds) AddHold(hold);
    for (const ProjectForce& force : project_.forces) animation_.forces.push_back(ToForce(force));
    AddConstraints(project_, &animation_, &errors);
    CheckAnimation(animation_, cancel_, &errors);
    if (is_cancelled()) return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
    if (!errors.ok()) return *errors.error();
    WarnAboutPlacements(animation_, &warnings_);
    WarnAboutForces(animation_, &warnings_);
    WarnAboutConstraints(animation_, &warnings_);
    WarnAboutContacts(animation_, &warnings_);
    std::sort(animation_.placements.begin(), animation_.placements.end(),
              [](const auto& a, const auto& b) { return a.first_frame < b.first_frame; });
    return Compiled{std::move(animation_), std::move(warnings_)};
  }

 private:
  bool is_cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }

  void Warn(std::string place, Check check, std::initializer_list<std::string_view> arguments) {
    warnings_.push_back({std::move(place), MessageOf(check, arguments)});
  }

  std::optional<GroupIndex> GroupOf(const std::string& name) const {
    const auto meant = FindJoints(*figure_, name);
    return meant ? std::optional(meant->group) : std::nullopt;
  }

  void AddSettings() {
    animation_.figure = figure_;
    animation_.rate = {project_.fps.num, project_.fps.den};
    animation_.first_frame = project_.frames.first;
    animation_.last_frame = project_.frames.last;
    const ProjectSolver& solver = project_.solver;
    animation_.solver = {solver.method, solver.step_s.value_or(kDefaultStep),
                         solver.tolerance_deg.value_or(kDefaultToleranceDeg) * kDegree,
                         solver.version};
    animation_.gravity = project_.scene.gravity_m_s2;
  }

  void AddCurves() {
    for (int i = 0; i < kNumRootCurves; ++i) {
      const double scale = i <= kRootZ ? 1.0 : kDegree;
      animation_.root_keys[i] = ToKeys(project_.root.curves[i], scale);
    }
    animation_.joint_keys.resize(figure_->joints().size());
    for (const auto& joint : project_.joints) {
      const JointIndex j = *figure_->FindJoint(joint.name);
      animation_.joint_keys[j.value()] = ToKeys(joint.value, kDegree);
      WarnAboutLimits(figure_->joint(j), joint);
    }
  }

  // One warning a curve, at the first key outside.
  void WarnAboutLimits(const Joint& joint, const Named<ProjectCurve>& curve) {
    constexpr double kTolerance = 1e-9;
    const Keys& keys = animation_.joint_keys[figure_->FindJoint(joint.name)->value()];
    const auto is_outside = [&](const Key& key) {
      return key.value < joint.lower - kTolerance || key.value > joint.upper + kTolerance;
    };
    const auto count = std::count_if(keys.begin(), keys.end(), is_outside);
    if (count == 0) return;
    const auto first = std::find_if(keys.begin(), keys.end(), is_outside) - keys.begin();
    Warn("joints." + joint.name + ".keys[" + std::to_string(first) + "].angle_deg",
         Check::kKeyOutsideLimits,
         {NumberText(curve.value.keys[static_cast<size_t>(first)].value),
          NumberText(RoundedDegrees(joint.lower)), NumberText(RoundedDegrees(joint.upper)),
          Quoted(joint.name), std::to_string(count)});
  }

  void AddScene() {
    for (const ProjectSceneObject& object : project_.scene.objects) {
      const Obstacle shape =
          std::visit([](const auto& item) { return ToObstacle(item); }, object.shape);
      animation_.scene.push_back({object.name, shape, object.color, object.friction_coefficient});
    }
    for (const ProjectHeldObject& object : project_.held_objects) {
      animation_.held_objects.push_back(ToHeldObject(object));
    }
  }

  HeldObject ToHeldObject(const ProjectHeldObject& source) const {
    HeldObject object;
    object.name = source.name;
    object.shape = std::visit([](const auto& item) { return ToShape(item); }, source.shape);
    object.mass = source.mass_kg;
    object.color = source.color;
    object.mesh = source.mesh.skin;
    object.touches_scene = source.contacts;
    object.friction = source.friction_coefficient;
    object.restitution = source.restitution;
    if (!source.joint.empty()) {
      object.holders.push_back({*GroupOf(source.joint), source.offset_m, Holder::kFromTheStart,
                                source.release_frame, RotationFromAngles(source.rotation_deg)});
    }
    for (const ProjectHolder& next : source.holders) {
      object.holders.push_back({*GroupOf(next.joint), next.offset_m, next.first_frame,
                                next.last_frame, RotationFromAngles(next.rotation_deg)});
    }
    for (int axis = 0; axis < 3; ++axis) {
      object.keys[axis] = ToKeys(source.position.curves[axis], 1.0);
    }
    return object;
  }

  void AddRegion(size_t index) {
    const ProjectRegion& source = project_.regions[index];
    DynamicsRegion region;
    region.name = source.name;
    region.first_frame = source.first_frame;
    region.last_frame = source.last_frame;
    region.method = source.method.value_or(project_.solver.method);
    region.step = source.step_s;
    region.limit_tangents = source.limit_tangents;
    region.blend_frames = source.blend_frames;
    if (source.tolerance_deg) region.tolerance = *source.tolerance_deg * kDegree;
    region.root = DrivesRoot(source, *figure_);
    region.touches_scene = source.contacts.scene;
    region.touches_self = source.contacts.self;
    region.joints = FreeJoints(source, "regions[" + std::to_string(index) + "].joints");
    AddDrives(source, &region);
    const std::vector<double> factors = FrictionFactors(source.friction);
    for (JointIndex j : region.joints) region.friction.push_back(factors[j.value()]);
    if (source.mute) Mute(&region);
    animation_.regions.push_back(std::move(region));
  }

  static void Mute(DynamicsRegion* region) {
    region->is_muted = true;
    region->root = false;
    region->touches_scene = region->touches_self = false;
    region->joints.clear();
    region->friction.clear();
    region->drives.clear();
    region->keyed.clear();
  }

  // A joint that is driven by its keys is none of the region's.
  void AddDrives(const ProjectRegion& source, DynamicsRegion* region) const {
    for (const ProjectDrive& drive : source.drives) {
      const std::vector<bool> meant = JointsOf(drive.joints, *figure_);
      const auto is_meant = [&](JointIndex j) { return meant[j.value()]; };
      if (drive.kind == DriveKind::kKeys) {
        std::copy_if(region->joints.begin(), region->joints.end(),
                     std::back_inserter(region->keyed), is_meant);
        std::erase_if(region->joints, is_meant);
        continue;
      }
      Drive own;
      own.kind = drive.kind;
      std::copy_if(region->joints.begin(), region->joints.end(), std::back_inserter(own.joints),
                   is_meant);
      if (own.joints.empty()) continue;
      if (drive.kind == DriveKind::kTorque) own.torque = ToKeys(drive.torque, 1.0);
      if (drive.kind == DriveKind::kSpring) {
        own.target = drive.to;
        own.frequency = drive.frequency_hz;
        own.damping_ratio = drive.damping_ratio;
        own.max_torque = drive.max_torque_n_m;
        own.strength = drive.strength;
        own.frequency_keys = ToKeys(drive.frequency_over_time, 1.0);
        own.strength_keys = ToKeys(drive.strength_over_time, 1.0);
        own.feed_forward = drive.feed_forward;
      }
      region->drives.push_back(std::move(own));
    }
    std::sort(region->keyed.begin(), region->keyed.end());
  }

  std::vector<JointIndex> FreeJoints(const ProjectRegion& region, const std::string& place) {
    const std::vector<bool> meant = JointsOf(region, *figure_);
    std::vector<JointIndex> joints;
    std::string fixed;
    for (int j = 0; j < figure_->num_joints(); ++j) {
      const Joint& joint = figure_->joints()[j];
      if (!meant[j]) continue;
      if (joint.is_fixed()) {
        fixed += (fixed.empty() ? "" : ", ") + joint.name;
      } else {
        joints.emplace_back(j);
      }
    }
    if (!fixed.empty()) Warn(place, Check::kFixedLeftOut, {fixed});
    return joints;
  }

  // By joint. Groups first, so that a hinge's own factor has the last word.
  std::vector<double> FrictionFactors(const ProjectFriction& friction) const {
    std::vector<double> factors(figure_->joints().size(), friction.default_factor);
    for (const bool groups : {true, false}) {
      for (const auto& entry : friction.joints) {
        if (figure_->FindGroup(entry.name).has_value() != groups) continue;
        const MeantJoints meant = *FindJoints(*figure_, entry.name);
        std::fill(factors.begin() + meant.first.value(), factors.begin() + meant.end.value(),
                  entry.value);
      }
    }
    return factors;
  }

  void AddPlacement(const ProjectPlacement& source) {
    PlacementSpan span{source.kind, source.first_frame, source.last_frame, {}, {}};
    if (source.kind != PlacementKind::kKeyed) span.pin = GroupOf(source.pin);
    if (source.kind == PlacementKind::kGravity) span.landing_pin = GroupOf(source.landing_pin);
    animation_.placements.push_back(span);
  }

  void AddHold(const ProjectHold& source) {
    animation_.holds.push_back({*GroupOf(source.joint), source.first_frame, source.last_frame,
                                source.orientation, source.reach});
  }

  OuterForce ToForce(const ProjectForce& source) const {
    OuterForce force{source.name, source.action, source.first_frame, source.last_frame};
    if (ForcePoint* point = ForcePointOf(&force.action)) point->joint = GroupOf(source.joint);
    if (IsOneFrame(source)) force.last_frame = source.first_frame + 1;
    return force;
  }

  const Project& project_;
  const std::atomic<bool>* cancel_;
  std::shared_ptr<const Figure> figure_;
  Animation animation_;
  std::vector<Warning> warnings_;
};

}  // namespace

Result<Compiled> CompileAnimation(const Project& project, const std::atomic<bool>* cancel,
                                  std::shared_ptr<const Figure> figure) {
  FirstError errors;
  CheckDocument(project, &errors);
  if (!errors.ok()) return *errors.error();
  if (!figure) {
    Result<Figure> built = BuildFigure(project.figure.spec);
    if (!built.ok()) return InFigure(built.error());
    figure = std::make_shared<const Figure>(std::move(built).value());
  }
  CheckNames(project, *figure, &errors);
  if (!errors.ok()) return *errors.error();
  return Compiler(project, std::move(figure), cancel).Compile();
}

}  // namespace hazumi
