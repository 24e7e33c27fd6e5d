#include "tests/property/random_working_region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "tests/property/random_drives.h"
#include "tests/property/random_region.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

namespace {

constexpr int kFrames = 30;

// Every second figure has surfaces on some links, and strengths where it has none.
Figure FigureThatWorks(Random* random) {
  FigureSpec spec = RandomFigureSpec(/*has_limits=*/true, random);
  const bool has_surfaces = random->Chance(0.5), has_strengths = random->Chance(0.5);
  for (JointSpec& joint : spec.joints) {
    for (LinkSpec& link : joint.links) {
      if (!has_surfaces || !random->Chance(0.5)) continue;
      LinkSurface surface;
      surface.area = random->LogUniform(0.003, 0.1);
      surface.normal = random->Rotation().col(0);
      surface.center = link.to;
      surface.kind = random->Chance(0.5) ? LinkSurface::Kind::kPlate : LinkSurface::Kind::kWing;
      link.surface = surface;
    }
    for (HingeSpec& hinge : joint.hinges) {
      if (!has_strengths || hinge.strength) continue;
      StrengthCurve curve;
      curve.torque = random->LogUniform(3.0, 100.0);
      hinge.strength = JointStrength{curve, curve};
    }
  }
  return Build(spec);
}

class RegionMaker {
 public:
  explicit RegionMaker(uint64_t seed)
      : random_(seed),
        animation_(Still(FigureThatWorks(&random_))),
        figure_(*animation_.figure),
        ws_(figure_) {
    animation_.solver.method = Method::kExact;
    animation_.last_frame = kFrames;
  }

  WorkingRegion Make() {
    WorkingRegion made;
    for (bool& acts : made.acts) acts = random_.Chance(0.5);
    ChooseRegions();
    if (made.has(Acting::kConstraints) && random_.Chance(0.6)) KeepKeyedStill();
    if (made.has(Acting::kDrives)) AddRandomDrives(&random_, &animation_);
    PoseAtStart();
    const bool moves = !MovedGroups().empty();  // limits may leave no hinge any room
    if (moves && made.has(Acting::kForces)) AddForces();
    if (moves && made.has(Acting::kContacts)) AddContacts();
    if (moves && made.has(Acting::kConstraints)) AddConstraints();
    made.animation = animation_;
    return made;
  }

 private:
  const DynamicsRegion& first() const { return animation_.regions[0]; }
  bool flies() const {
    return !animation_.placements.empty() &&
           animation_.placements[0].kind == PlacementKind::kGravity;
  }

  // ---- who moves

  void ChooseRegions() {
    DynamicsRegion region;
    region.name = "region";
    region.method = Method::kExact;
    region.last_frame = kFrames;
    const bool is_whole = random_.Chance(0.25);
    if (is_whole) {
      for (int j = 0; j < figure_.num_joints(); ++j) region.joints.emplace_back(j);
    } else {
      ChooseJoints(figure_, &random_, &region);
    }
    ChooseFriction(&random_, &region);
    const auto moves = [](double friction) { return friction > 0.0; };
    if (std::none_of(region.friction.begin(), region.friction.end(), moves)) {
      std::fill(region.friction.begin(), region.friction.end(), 0.8);
    }
    ChooseKeys(region, &random_, &animation_);
    ChooseRoot(&random_, &region, &animation_);
    if (is_whole) {
      region.root = !animation_.placements.empty();
      for (Keys& keys : animation_.joint_keys) *keys[0].rate *= 0.2;
    }
    animation_.regions.push_back(std::move(region));
    if (!is_whole && random_.Chance(0.3)) SplitRegion();
  }

  // Joints from the middle of the list on, whole groups of them, are another region's.
  void SplitRegion() {
    const DynamicsRegion all = first();
    const size_t middle = all.joints.size() / 2;
    const auto group_of = [&](size_t i) { return figure_.joint(all.joints[i]).group; };
    size_t at = middle;
    while (at > 0 && group_of(at - 1) == group_of(middle)) --at;
    const auto count = static_cast<std::ptrdiff_t>(at);
    if (count == 0) return;
    DynamicsRegion& one = animation_.regions[0];
    one.joints.resize(at);
    one.friction.resize(at);
    DynamicsRegion two = all;
    two.name = "other";
    two.root = false;
    two.joints.erase(two.joints.begin(), two.joints.begin() + count);
    two.friction.erase(two.friction.begin(), two.friction.begin() + count);
    animation_.regions.push_back(std::move(two));
  }

  bool IsInRegion(JointIndex j) const {
    return std::any_of(animation_.regions.begin(), animation_.regions.end(),
                       [&](const DynamicsRegion& region) {
                         return std::binary_search(region.joints.begin(), region.joints.end(), j);
                       });
  }

  // Whether keys move it.
  bool FollowsCurve(JointIndex j) const {
    return !IsInRegion(j) && animation_.joint_keys[j.value()].size() > 1;
  }

  // Joints outside regions and a keyed root stand still: constraints hold on to them.
  void KeepKeyedStill() {
    const auto still = [](Keys* keys) {
      *keys = {{0, keys->front().value, {}, Interpolation::kHold}};
    };
    for (int j = 0; j < figure_.num_joints(); ++j) {
      if (!IsInRegion(JointIndex(j))) still(&animation_.joint_keys[j]);
    }
    for (int i = 0; i < kNumRootCurves; ++i) {
      const bool is_angle = i >= kRootAngleZ;
      if (is_angle ? !first().root : !flies()) still(&animation_.root_keys[i]);
    }
  }

  void PoseAtStart() {
    Animation alone = animation_;
    alone.regions.clear();
    alone.placements.clear();
    const MotionFrame start = BakeOrFail(alone).frames.front();
    X_WR_ = start.X_WR;
    ComputePositions(figure_, X_WR_, start.q, &ws_);
  }

  // ---- points of bodies

  double MassBeyond(GroupIndex group) const {
    double sum = 0.0;
    const JointIndex first = figure_.group(group).first;
    for (int j = first.value(); j < figure_.joint(first).subtree_end.value(); ++j) {
      sum += figure_.body(JointIndex(j)).mass;
    }
    return sum;
  }

  bool IsMoved(JointIndex joint) const {
    for (JointIndex j = joint; j.is_valid(); j = figure_.joint(j).parent) {
      if (IsFree(animation_, j)) return true;
    }
    return false;
  }

  // Groups whose bodies a region moves.
  std::vector<GroupIndex> MovedGroups() const {
    std::vector<GroupIndex> moved;
    for (int g = 0; g < static_cast<int>(figure_.groups().size()); ++g) {
      if (IsMoved(figure_.groups()[g].last())) moved.emplace_back(g);
    }
    return moved;
  }
  GroupIndex MovedGroup() {
    const std::vector<GroupIndex> moved = MovedGroups();
    return moved[random_.Integer(0, static_cast<int>(moved.size()) - 1)];
  }

  Pose PoseOf(const std::optional<GroupIndex>& group) const {
    if (!group) return X_WR_;
    const BodyScratch& body = ws_.body(figure_.group(*group).last());
    return {body.R, body.p};
  }

  Vec3 PlaceOf(GroupIndex group) const { return PoseOf(group).p; }

  // ---- forces

  void AddForces() {
    const bool is_windy = random_.Chance(0.5);
    if (is_windy) Add(WindForce{random_.Vector3(10.0), random_.LogUniform(0.5, 3.0)});
    const int pulls = random_.Integer(is_windy ? 0 : 1, 2), pushes = random_.Integer(0, 2);
    for (int i = 0; i < pulls; ++i) {
      const GroupIndex group = MovedGroup();
      const Vec3 to = PlaceOf(group) + random_.Vector3(1.0);
      const double force = MassBeyond(group) * random_.LogUniform(1.0, 30.0);
      const double radius = random_.LogUniform(0.05, 1.0);
      Add(AttractForce{{group, random_.Vector3(0.2)}, to, force, radius});
    }
    for (int i = 0; i < pushes; ++i) {
      const GroupIndex group = MovedGroup();
      const Vec3 impulse = MassBeyond(group) * random_.Vector3(2.0);
      Add(PushForce{{group, random_.Vector3(0.1)}, impulse});
    }
  }

  void Add(decltype(OuterForce::action) action) {
    OuterForce force{"force " + std::to_string(animation_.forces.size()), action, 0, kFrames};
    const bool is_push = force.kind() == ForceKind::kPush;
    if (is_push || random_.Chance(0.5)) force.first_frame = random_.Integer(0, kFrames - 1);
    if (is_push) force.last_frame = force.first_frame + 1;
    animation_.forces.push_back(std::move(force));
  }

  // ---- what is touched

  // Of what stays out of the scene, from it at the start [m].
  double ClearanceFrom(const SceneObject& object) const {
    const bool all = first().root || flies();
    const auto counts = [&](int link, int /*object*/) {
      const JointIndex joint = figure_.links()[link].joint;
      return all || (joint.is_valid() && IsMoved(joint));
    };
    const auto contact = NearestContact(figure_, {object}, ws_, Vec3::Zero(), counts);
    return contact ? contact->clearance : HUGE_VAL;
  }

  void AddContacts() {
    for (DynamicsRegion& region : animation_.regions) region.touches_scene = true;
    if (random_.Chance(0.7)) AddGround();
    for (int left = random_.Integer(animation_.scene.empty() ? 1 : 0, 4); left > 0; --left) {
      AddBox();
    }
    for (size_t i = 0; i < animation_.scene.size(); ++i) {
      animation_.scene[i].name = "object " + std::to_string(i);
      animation_.scene[i].friction = random_.Uniform(0.1, 1.2);
    }
  }

  void AddGround() {
    SceneObject ground;
    const Vec3 tilted = Vec3::UnitZ() + random_.Vector3(0.3);
    const Vec3 normal = random_.Chance(0.3) ? Vec3(tilted.normalized()) : Vec3(Vec3::UnitZ());
    ground.shape = Plane{normal, 0.0};
    const double above = ClearanceFrom(ground);
    if (!std::isfinite(above)) return;
    ground.shape = Plane{normal, above - random_.Uniform(0.001, 0.4)};
    animation_.scene.push_back(ground);
  }

  // Near a body that moves, which it may reach.
  void AddBox() {
    for (int tries = 0; tries < 20; ++tries) {
      SceneObject box;
      const Vec3 half = {random_.Uniform(0.05, 0.5), random_.Uniform(0.05, 0.5),
                         random_.Uniform(0.05, 0.4)};
      const Mat3 R = random_.Chance(0.5) ? Mat3(random_.Rotation()) : Mat3(Mat3::Identity());
      const Vec3 near = PlaceOf(MovedGroup());
      box.shape = Box{{R, near + random_.Vector3(1.0)}, half};
      const double clearance = ClearanceFrom(box);
      if (clearance < 0.001 || clearance > 0.5) continue;
      return animation_.scene.push_back(box);
    }
  }

  // ---- constraints

  // What lies between two bodies, or one and the world.
  struct Way {
    int num_free = 0;         // hinges
    bool has_moving = false;  // what keys move
  };

  Way WayBetween(JointIndex a, const std::optional<JointIndex>& b) const {
    Way way;
    for (int j = 0; j < figure_.num_joints(); ++j) {
      const bool carries_b = b && b->is_valid() && figure_.IsBeyond(*b, JointIndex(j));
      if (figure_.IsBeyond(a, JointIndex(j)) == carries_b) continue;
      way.num_free += IsFree(animation_, JointIndex(j));
      way.has_moving |= FollowsCurve(JointIndex(j));
    }
    if (b || first().root) return way;
    for (int i = flies() ? static_cast<int>(kRootAngleZ) : 0; i < kNumRootCurves; ++i) {
      way.has_moving |= animation_.root_keys[i].size() > 1;
    }
    return way;
  }

  void AddConstraints() {
    const int wanted = random_.Chance(0.3) ? 2 : 1;
    for (int tries = 0; tries < 50; ++tries) {
      if (static_cast<int>(animation_.constraints.size()) == wanted) return;
      const GroupIndex a = MovedGroup();
      const int end = random_.Integer(-1, static_cast<int>(figure_.groups().size()) - 1);
      const bool is_in_world = random_.Chance(0.4);
      std::optional<GroupIndex> b;  // none: the root
      if (end >= 0) b = GroupIndex(end);
      if (!is_in_world && b == a) continue;
      std::optional<JointIndex> other;
      if (!is_in_world) other = b ? figure_.group(*b).last() : JointIndex();
      const Way way = WayBetween(figure_.group(a).last(), other);
      if (way.num_free > 0) Add(a, b, is_in_world, way.has_moving);
    }
  }

  void Add(GroupIndex a, const std::optional<GroupIndex>& b, bool is_in_world, bool must_arrive) {
    Constraint constraint;
    constraint.name = "constraint " + std::to_string(animation_.constraints.size());
    constraint.kind = static_cast<ConstraintKind>(random_.Integer(0, 2));
    constraint.last_frame = kFrames;
    constraint.a.joint = a;
    constraint.a.offset = random_.Vector3(0.2);
    if (must_arrive || random_.Chance(0.4)) {
      constraint.arrive_frames = random_.Integer(3, 15);
      if (random_.Chance(0.5)) constraint.first_frame = random_.Integer(1, 15);
    }
    const bool arrives = constraint.arrive_frames > 0;
    if (random_.Chance(0.3)) constraint.last_frame = random_.Integer(20, kFrames);
    const Pose X_WA = PoseOf(a) * Pose{Mat3::Identity(), constraint.a.offset};
    const Pose X_WB = is_in_world ? Pose() : PoseOf(b);
    Pose target = X_WA;
    if (arrives) {
      const double angle = random_.Uniform(-0.3, 0.3);
      target.p += random_.Vector3(0.15);
      target.R = target.R * AxisRotation<double>(Vec3::UnitX(), std::sin(angle), std::cos(angle));
    }
    if (constraint.kind == ConstraintKind::kDistance) {
      constraint.length = random_.Uniform(0.1, 0.5);
      target.p = X_WA.p + constraint.length * random_.Rotation().col(0);
      if (arrives) constraint.length *= random_.Uniform(0.7, 1.2);
    }
    target = X_WB.Inverse() * target;
    constraint.b = {is_in_world, is_in_world ? std::nullopt : b, target.p, target.R, {}};
    if (random_.Chance(0.25)) constraint.break_force = random_.LogUniform(20.0, 2000.0);
    if (random_.Chance(0.25)) constraint.break_impulse = random_.LogUniform(0.5, 50.0);
    animation_.constraints.push_back(constraint);
  }

  Random random_;
  Animation animation_;
  const Figure& figure_;
  Pose X_WR_;             // at the start
  DynamicsWorkspace ws_;  // there
};

}  // namespace

WorkingRegion RandomWorkingRegion(uint64_t seed) { return RegionMaker(seed).Make(); }

}  // namespace hazumi::test
