#include "engine/bake/walk/contacts_of.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine/bake/pose/contact_obstacles.h"

namespace hazumi {

namespace {

// Whether a link is at this end, or beyond it.
bool IsOf(const ConstraintEnd& end, int link, const Figure& figure) {
  if (end.is_in_world) return false;
  const JointIndex joint = figure.links()[link].joint;
  if (!end.joint) return !joint.is_valid();
  return figure.IsBeyond(joint, figure.group(*end.joint).last());
}

class Lister {
 public:
  Lister(const RegionModel& model, const Figure& figure, ContactSpec* spec)
      : model_(model), figure_(figure), spec_(spec), capsule_of_(figure.links().size(), -1) {}

  void MeetObstacles(int link) {
    const NodeJoint* seat = SeatOf(link);
    if (seat && IsMoved(*seat)) spec_->capsules[CapsuleOf(link, *seat)].meets_obstacles = true;
  }

  // Removes contacts between the two ends of a constraint.
  void Part(const Constraint& constraint) {
    for (size_t i = 0; i < figure_.links().size(); ++i) {
      if (capsule_of_[i] < 0) continue;
      for (size_t o = 0; o < spec_->obstacles.size(); ++o) {
        const int object = spec_->obstacles[o].object;
        if (!IsParted(static_cast<int>(i), object, constraint, figure_)) continue;
        spec_->exempt.push_back({capsule_of_[i], static_cast<int>(o)});
      }
    }
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
    spec_->own.push_back({own, other, MixFriction(SceneObject::kFriction, SceneObject::kFriction)});
  }

  void MeetBall(int ball, const HeldObject& object) {
    const int capsule = static_cast<int>(spec_->capsules.size());
    ContactCapsule own;
    own.node = model_.NodeOfBall(ball);
    own.radius = std::get<SphereShape>(object.shape).radius;
    own.restitution = object.restitution;
    own.ball = model_.balls[ball].object;
    // Obstacles have the coefficients that they have with a figure: sqrt(0.8 a) sqrt(b / 0.8).
    own.friction = std::sqrt(object.friction / SceneObject::kFriction);
    spec_->capsules.push_back(own);
    for (const auto& [other, other_friction] : balls_) {
      spec_->own.push_back({other, capsule, MixFriction(object.friction, other_friction)});
    }
    if (spec_->rules.keeps_balls_apart) balls_.emplace_back(capsule, object.friction);
    const double friction = MixFriction(object.friction, SceneObject::kFriction);
    for (size_t i = 0; i < figure_.links().size(); ++i) {
      const int link = static_cast<int>(i);
      if (const NodeJoint* seat = SeatOf(link)) {
        spec_->own.push_back({CapsuleOf(link, *seat), capsule, friction});
      }
    }
  }

 private:
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
  std::vector<int> capsule_of_;                // by link; none: -1
  std::vector<std::pair<int, double>> balls_;  // capsule and friction of those that are listed
};

}  // namespace

std::vector<const Constraint*> PartingConstraints(const Animation& animation,
                                                  const std::vector<int>& constraints) {
  std::vector<const Constraint*> parting;
  if (!animation.solver.rules().parts_what_is_tied) return parting;
  for (const int i : constraints) {
    if (animation.constraints[i].parts()) parting.push_back(&animation.constraints[i]);
  }
  return parting;
}

bool AreParted(const LinkPair& pair, const Constraint& constraint, const Figure& figure) {
  const auto is_of = [&](const ConstraintEnd& end, int link) { return IsOf(end, link, figure); };
  return (is_of(constraint.a, pair.a) && is_of(constraint.b, pair.b)) ||
         (is_of(constraint.a, pair.b) && is_of(constraint.b, pair.a));
}

bool IsParted(int link, int object, const Constraint& constraint, const Figure& figure) {
  return (constraint.b.object == object && IsOf(constraint.a, link, figure)) ||
         (constraint.a.object == object && IsOf(constraint.b, link, figure));
}

ContactSpec ContactsOf(const RegionModel& model, const Figure& figure, const Animation& animation,
                       const std::function<bool(JointIndex)>& touches,
                       const std::vector<LinkPair>& own, const std::vector<int>& constraints) {
  const std::vector<const Constraint*> parting = PartingConstraints(animation, constraints);
  ContactSpec spec;
  spec.rules = animation.solver.rules();
  spec.obstacles = ObstaclesOf(animation.scene, SceneObject::kFriction);
  Lister lister(model, figure, &spec);
  for (size_t i = 0; i < figure.links().size(); ++i) {
    if (touches(figure.links()[i].joint)) lister.MeetObstacles(static_cast<int>(i));
  }
  for (const LinkPair& pair : own) {
    const auto parts = [&](const Constraint* constraint) {
      return AreParted(pair, *constraint, figure);
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
