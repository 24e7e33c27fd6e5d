// With r the arm of the pin, alpha and w of its node, g gravity's acceleration, the root's
// acceleration less gravity's is
//   prescribed  x'' - g,     in flight  0,     pinned  -g - (a_pin + alpha x r + w x (w x r))
// and its place the prescribed one, or that for which the pin, or in flight the centre of mass, is
// where it has to be.

#include "engine/region/region_kinematics.h"

#include "engine/base/assert.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

RegionKinematics::RegionKinematics(const RegionModel* model, double gravity,
                                   const IslandNeeds& needs)
    : model_(model), gravity_(gravity), needs_(needs), nodes_(*model) {
  while (!model_->nodes[first_moved_].is_dynamic) ++first_moved_;
  if (!needs_.world) return;
  places_.resize(model_->num_nodes());
  velocities_.resize(model_->nodes.size());
}

void RegionKinematics::SetCurves(const DrivenMotion* driven, double start,
                                 const RegionLayout& layout) {
  driven_ = driven;
  if (first_moved_ == 0) return;
  is_base_still_ = !needs_.rows && IsBaseStill();
  if (is_base_still_) PlaceStillBase(start, layout);
}

bool RegionKinematics::IsBaseStill() const {
  for (int i = 0; i < first_moved_; ++i) {
    if (model_->nodes[i].role == Role::kDriven) return false;
  }
  const auto& root = driven_->root_position;
  const auto accelerates = [](const DrivenCurve& curve) { return curve.degree > 1; };
  return model_->coupling == RootCoupling::kPinned ||
         std::none_of(root.begin(), root.end(), accelerates);
}

// Places the nodes of a base that stays where it is, once for all times.
void RegionKinematics::PlaceStillBase(double t, const RegionLayout& layout) {
  nodes_.Move(layout, *driven_, t, nullptr, nullptr, 0, first_moved_);
  NodeMotion& base = nodes_.motion()[model_->nodes[first_moved_].parent];
  base.a += BaseAcceleration(t);
  is_base_placed_ = true;
}

std::shared_ptr<const MovingBase> RegionKinematics::FitMovingBase(double start, double end,
                                                                  const RegionLayout& layout) {
  return std::make_shared<const MovingBase>(start, end, SmoothUntil(end),
                                            [&](double t) { return BaseAt(t, layout); });
}

MovingBase::Frame RegionKinematics::BaseAt(double t, const RegionLayout& layout) {
  const NodeMotion& own = nodes_.motion()[model_->nodes[first_moved_].parent];
  nodes_.Move(layout, *driven_, t, nullptr, nullptr, 0, first_moved_);
  return {own.R, own.w, own.alpha, own.a + BaseAcceleration(t)};
}

// Laws that act from outside ask for more of the chain than a moving base knows.
void RegionKinematics::MoveBase(double t, const RegionLayout& layout) {
  const bool is_fitted = !needs_.world && moving_base_->Covers(t);
  const MovingBase::Frame frame = is_fitted ? moving_base_->At(t) : BaseAt(t, layout);
  NodeMotion& own = nodes_.motion()[model_->nodes[first_moved_].parent];
  own.R = frame.R;
  own.w = frame.w;
  own.alpha = frame.alpha;
  own.a = frame.a;
}

RegionState RegionKinematics::Place(double t, const RegionLayout& layout, const double* positions,
                                    const double* velocities, const OuterMotion& outer) {
  HAZUMI_ASSERT(driven_ != nullptr);
  const bool has_base = first_moved_ > 0 && !needs_.rows;
  if (has_base && !is_base_still_) MoveBase(t, layout);
  if (has_base && is_base_still_ && !is_base_placed_) PlaceStillBase(t, layout);
  nodes_.Move(layout, *driven_, t, positions, velocities, has_base ? first_moved_ : 0,
              nodes_.size());
  AskForInertia(t, has_base ? V3() : BaseAcceleration(t), outer);
  placed_at_ = {t, &layout, positions};
  return Placed(t, layout, positions, velocities);
}

RegionState RegionKinematics::PlaceWithChain(double t, const RegionLayout& layout,
                                             const double* positions, const double* velocities) {
  nodes_.Move(layout, *driven_, t, positions, velocities, 0, nodes_.size());
  is_base_placed_ = false;
  placed_at_ = {t, &layout, positions};
  return Placed(t, layout, positions, velocities);
}

void RegionKinematics::AskForInertia(double t, const V3& base, const OuterMotion& outer) {
  if (needs_.forces || needs_.rows) nodes_.ClearForces();  // those of massless nodes too
  nodes_.SetOwnForces(base);
  if (needs_.world) PlaceInWorld(t, outer);
}

V3 RegionKinematics::BaseAcceleration(double t) const {
  const V3 up(0.0, 0.0, gravity_);
  if (model_->coupling == RootCoupling::kFlight) return {};
  if (model_->coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = nodes_.motion()[model_->pin_node];
    const V3 r = pin.R * V3(model_->p_pin);
    return up - (pin.a + Cross(pin.alpha, r) + Cross(pin.w, Cross(pin.w, r)));
  }
  const auto& root = driven_->root_position;
  return up + V3(root[0].At(t).dd, root[1].At(t).dd, root[2].At(t).dd);
}

V3 RegionKinematics::RootVelocity(double t, std::vector<V3>* velocities) const {
  const auto& motion = nodes_.motion();
  V3 momentum;
  for (int i = 0; i < nodes_.size(); ++i) {
    const int parent = model_->nodes[i].parent;
    V3& v = (*velocities)[i];
    v = parent < 0 ? V3() : (*velocities)[parent] + Cross(motion[parent].w, motion[i].r);
    if (!model_->nodes[i].is_dynamic) continue;
    momentum += motion[i].m * v + Cross(motion[i].w, motion[i].h);
  }
  if (model_->coupling == RootCoupling::kFlight) return (-1.0 / model_->mass) * momentum;
  if (model_->coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = motion[model_->pin_node];
    return -((*velocities)[model_->pin_node] + Cross(pin.w, pin.R * V3(model_->p_pin)));
  }
  const auto& root = driven_->root_position;
  return {root[0].At(t).d, root[1].At(t).d, root[2].At(t).d};
}

V3 RegionKinematics::RootPosition(double t, const OuterMotion& outer) const {
  const auto& motion = nodes_.motion();
  const V3 anchor(outer.anchor.p);
  if (model_->coupling == RootCoupling::kFlight) {
    V3 sum;
    for (const NodeMotion& own : motion) sum += own.m * own.p + own.h;
    return anchor - (1.0 / model_->mass) * sum;
  }
  if (model_->coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = motion[model_->pin_node];
    return anchor - (pin.p + pin.R * V3(model_->p_pin));
  }
  const auto& root = driven_->root_position;
  return {root[0].At(t).v, root[1].At(t).v, root[2].At(t).v};
}

void RegionKinematics::PlaceInWorld(double t, const OuterMotion& outer) {
  const V3 p_root = RootPosition(t, outer);
  V3 v_root = RootVelocity(t, &velocities_);
  if (model_->coupling == RootCoupling::kFlight) v_root += V3(outer.anchor.v);
  for (int i = 0; i < nodes_.size(); ++i) {
    places_[i] = {p_root + nodes_.motion()[i].p, v_root + velocities_[i]};
  }
  PlaceBalls(p_root, outer);
}

void RegionKinematics::PlaceBalls(const V3& p_root, const OuterMotion& outer) {
  HAZUMI_ASSERT(outer.balls.size() == model_->balls.size());
  for (int i = 0; i < static_cast<int>(outer.balls.size()); ++i) {
    const BodyMotion& ball = outer.balls[i];
    const int node = model_->NodeOfBall(i);
    NodeMotion& own = nodes_.motion()[node];
    places_[node] = {V3(ball.X_WB.p), V3(ball.v)};
    own.R = ToSmall(ball.X_WB.R);
    own.p = places_[node].p - p_root;
    own.w = V3(ball.w);
  }
}

}  // namespace hazumi
