#include "engine/analysis/problems/sinking.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi {

namespace {

bool IsByGravity(const std::vector<PlacementSpan>& placements, int frame) {
  return std::any_of(placements.begin(), placements.end(), [&](const PlacementSpan& span) {
    return span.kind == PlacementKind::kGravity && frame >= span.first_frame &&
           frame <= span.last_frame;
  });
}

// Whether a constraint ties an object to the figure: a hand that grips it is inside it by as much
// as its fingers are drawn straight.
bool IsTied(int object, const Animation& animation) {
  if (std::holds_alternative<Plane>(animation.scene[static_cast<size_t>(object)].shape)) {
    return false;
  }
  return std::any_of(animation.constraints.begin(), animation.constraints.end(),
                     [&](const Constraint& constraint) {
                       return constraint.a.object == object || constraint.b.object == object;
                     });
}

}  // namespace

bool SinkingFinder::Look(const Animation& animation, const Motion& motion, int most) {
  Begin(animation, motion.frames.size());
  std::optional<DynamicsWorkspace> ws;
  for (size_t i = 0; i < known_.size(); ++i) {
    const MotionFrame& frame = motion.frames[i];
    if (known_[i] && known_[i]->q == frame.q && known_[i]->X_WR == frame.X_WR) continue;
    known_[i].reset();
    if (most-- <= 0) continue;
    if (!ws) ws.emplace(*figure_);
    known_[i] = LookAt(frame, &*ws);
  }
  Collect(animation.placements, animation.first_frame);
  return most >= 0;
}

// Forgets what is known of another figure or scene.
void SinkingFinder::Begin(const Animation& animation, size_t num_frames) {
  std::vector<SceneObject> scene;
  for (int i = 0; i < static_cast<int>(animation.scene.size()); ++i) {
    if (!IsTied(i, animation)) scene.push_back(animation.scene[static_cast<size_t>(i)]);
  }
  if (figure_ != animation.figure || scene_ != scene) known_.clear();
  figure_ = animation.figure;
  scene_ = std::move(scene);
  known_.resize(num_frames);
}

SinkingFinder::Known SinkingFinder::LookAt(const MotionFrame& frame, DynamicsWorkspace* ws) const {
  Known known = {frame.q, frame.X_WR, 0.0, GroupIndex()};
  ComputePositions(*figure_, frame.X_WR, frame.q, ws);
  const std::optional<Contact> contact = NearestContact(*figure_, scene_, *ws);
  if (!contact || contact->clearance > -kDeep) return known;
  known.depth = -contact->clearance;
  if (!figure_->groups().empty()) known.joint = NearestGroup(*figure_, *ws, contact->point);
  return known;
}

// Joins frames in a row.
void SinkingFinder::Collect(const std::vector<PlacementSpan>& placements, int first_frame) {
  sinkings_.clear();
  for (size_t i = 0; i < known_.size(); ++i) {
    const int frame = first_frame + static_cast<int>(i);
    if (!known_[i] || known_[i]->depth == 0.0 || IsByGravity(placements, frame)) continue;
    if (sinkings_.empty() || sinkings_.back().last + 1 != frame) {
      sinkings_.push_back({frame, frame, frame, 0.0, {}});
    }
    Sinking& run = sinkings_.back();
    run.last = frame;
    if (known_[i]->depth <= run.depth) continue;
    run.deepest = frame;
    run.depth = known_[i]->depth;
    run.joint = known_[i]->joint;
  }
}

}  // namespace hazumi
