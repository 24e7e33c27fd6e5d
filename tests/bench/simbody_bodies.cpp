#include "tests/bench/simbody_bodies.h"

namespace hazumi::bench {

namespace {

SimbodyTree::Mobilizer MobilizerOf(const JointGroup& group, Threes threes) {
  if (group.size == 1) return SimbodyTree::Mobilizer::kPin;
  if (group.size == 2) return SimbodyTree::Mobilizer::kUniversal;
  return threes == Threes::kBall ? SimbodyTree::Mobilizer::kBall : SimbodyTree::Mobilizer::kGimbal;
}

SimbodyTree::Inertia InertiaOf(const RigidInertia& body) {
  return {body.mass, body.com, body.I_com + PointInertia(body.mass, body.com)};
}

}  // namespace

std::vector<SimbodyTree::Body> SimbodyBodies(const Figure& figure, Threes threes) {
  std::vector<SimbodyTree::Body> bodies;
  for (const JointGroup& group : figure.groups()) {
    const Joint& first = figure.joint(group.first);
    const int parent = first.parent.is_valid() ? figure.joint(first.parent).group.value() : -1;
    bodies.push_back({parent, MobilizerOf(group, threes), first.X_PJ.R, first.X_PJ.p,
                      HingeFrame(figure, group), InertiaOf(figure.body(group.last()))});
  }
  return bodies;
}

}  // namespace hazumi::bench
