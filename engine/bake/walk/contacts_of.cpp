// Between two surfaces with coefficients of friction a and b that of both is sqrt(a b).

#include "engine/bake/walk/contacts_of.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/bake/pose/contact_obstacles.h"

namespace hazumi {

namespace {

class Lister {
 public:
  Lister(const RegionModel& model, const Figure& figure, ContactSpec* spec)
      : model_(model), figure_(figure), spec_(spec), capsule_of_(figure.links().size(), -1) {}

  void MeetObstacles(int link) {
    const NodeJoint* seat = SeatOf(link);
    if (seat && IsMoved(*seat)) spec_->capsules[CapsuleOf(link, *seat)].meets_obstacles = true;
  }

  // Removes contacts between the two ends of a constraint: the links of its ends, and all links
  // beyond them.
  void Part(const Constraint& constraint) {
    for (const ConstraintEnd* end : {&constraint.a, &constraint.b}) {
      const ConstraintEnd& other = end == &constraint.a ? constraint.b : constraint.a;
      if (end->is_in_world || !other.object) continue;
      for (size_t i = 0; i < figure_.links().size(); ++i) {
        const int capsule = capsule_of_[i];
        if (capsule >= 0 && IsOf(*end, static_cast<int>(i))) Exempt(capsule, *other.object);
      }
    }
  }
  static bool AreParted(const LinkPair& pair, const Constraint& constraint, const Figure& figure) {
    if (constraint.a.is_in_world || constraint.b.is_in_world) return false;
    const auto is_of = [&](const ConstraintEnd& end, int link) { return IsOf(end, link, figure); };
    return (is_of(constraint.a, pair.a) && is_of(constraint.b, pair.b)) ||
           (is_of(constraint.a, pair.b) && is_of(constraint.b, pair.a));
  }

  // In the order that what is moved comes first.
  void MeetEachOther(LinkPair pair) {
    const NodeJoint *a = SeatOf(pair.a), *b = SeatOf(pair.b);
    if (!a || !b || a->node == b->node) return;
    if (!IsMoved(*a)) {
      std::swap(pair.a, pair.b);
      std::swap(a, b);
    }
    if (!IsMoved(*a)) return;
    const int own = CapsuleOf(pair.a, *a), other = CapsuleOf(pair.b, *b);
    spec_->own.push_back({own, other, SceneObject::kFriction});
  }

  void MeetBall(int ball, const HeldObject& object) {
    const int capsule = static_cast<int>(spec_->capsules.size());
    ContactCapsule own;
    own.node = model_.NodeOfBall(ball);
    own.radius = std::get<SphereShape>(object.shape).radius;
    own.restitution = object.restitution;
    own.ball = model_.balls[ball].object;
    own.friction = std::sqrt(object.friction / SceneObject::kFriction);
    spec_->capsules.push_back(own);
    const double friction = std::sqrt(object.friction * SceneObject::kFriction);
    for (size_t i = 0; i < figure_.links().size(); ++i) {
      const int link = static_cast<int>(i);
      if (const NodeJoint* seat = SeatOf(link)) {
        spec_->own.push_back({CapsuleOf(link, *seat), capsule, friction});
      }
    }
  }

 private:
  static bool IsOf(const ConstraintEnd& end, int link, const Figure& figure) {
    const JointIndex joint = figure.links()[link].joint;
    if (!end.joint) return !joint.is_valid();
    const JointIndex last = figure.group(*end.joint).last();
    return joint == last || (joint.is_valid() && figure.IsBeyond(joint, last));
  }
  bool IsOf(const ConstraintEnd& end, int link) const { return IsOf(end, link, figure_); }
  void Exempt(int capsule, int object) {
    for (size_t o = 0; o < spec_->obstacles.size(); ++o) {
      if (spec_->obstacles[o].object == object) {
        spec_->exempt.push_back({capsule, static_cast<int>(o)});
      }
    }
  }

  const NodeJoint* SeatOf(int link) const { return model_.SeatOf(figure_.links()[link].joint); }
  bool IsMoved(const NodeJoint& seat) const { return model_.nodes[seat.node].is_dynamic; }

  int CapsuleOf(int index, const NodeJoint& seat) {
    int& capsule = capsule_of_[index];
    if (capsule >= 0) return capsule;
    capsule = static_cast<int>(spec_->capsules.size());
    const Capsule& shape = figure_.links()[index].capsule;
    ContactCapsule own{seat.node, OnNode(seat, shape.a), OnNode(seat, shape.b), shape.radius,
                       index};
    own.meets_obstacles = false;
    spec_->capsules.push_back(own);
    return capsule;
  }

  const RegionModel& model_;
  const Figure& figure_;
  ContactSpec* spec_;
  std::vector<int> capsule_of_;  // by link; none: -1
};

}  // namespace

ContactSpec ContactsOf(const RegionModel& model, const Figure& figure, const Animation& animation,
                       const std::function<bool(JointIndex)>& touches,
                       const std::vector<LinkPair>& own, const std::vector<int>& constraints) {
  const SolverRules rules = animation.solver.rules();
  std::vector<const Constraint*> parting;
  for (const int i : constraints) {
    const Constraint& constraint = animation.constraints[i];
    if (rules.parts_what_is_tied && constraint.parts()) parting.push_back(&constraint);
  }
  ContactSpec spec;
  spec.rules = rules;
  spec.obstacles = ObstaclesOf(animation.scene, SceneObject::kFriction);
  Lister lister(model, figure, &spec);
  for (size_t i = 0; i < figure.links().size(); ++i) {
    if (touches(figure.links()[i].joint)) lister.MeetObstacles(static_cast<int>(i));
  }
  for (const LinkPair& pair : own) {
    const auto parts = [&](const Constraint* constraint) {
      return Lister::AreParted(pair, *constraint, figure);
    };
    if (std::none_of(parting.begin(), parting.end(), parts)) lister.MeetEachOther(pair);
  }
  for (const Constraint* constraint : parting) lister.Part(*constraint);
  for (int ball = 0; ball < static_cast<int>(model.balls.size()); ++ball) {
    lister.MeetBall(ball, animation.held_objects[model.balls[ball].object]);
  }
  return spec;
}

}  // namespace hazumi
