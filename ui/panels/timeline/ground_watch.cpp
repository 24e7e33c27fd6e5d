#include "ui/panels/timeline/ground_watch.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi::ui {

namespace {

bool IsByGravity(const std::vector<PlacementSpan>& placements, int frame) {
  return std::any_of(placements.begin(), placements.end(), [&](const PlacementSpan& span) {
    return span.kind == PlacementKind::kGravity && frame >= span.first_frame &&
           frame <= span.last_frame;
  });
}

// A hand that has something is in it by as much as its fingers are drawn straight.
bool IsHeldOnTo(const SceneObject& object, const Project& project) {
  if (std::holds_alternative<Plane>(object.shape)) return false;
  return std::any_of(project.constraints.begin(), project.constraints.end(),
                     [&](const ProjectConstraint& constraint) {
                       return constraint.a.object == object.name ||
                              constraint.b.object == object.name;
                     });
}

}  // namespace

void GroundWatch::Look(edit::Session* session, int most) {
  const Version now = {session->document_number(), session->document().revision()};
  if (is_done_ && now == seen_) return;
  is_done_ = true;
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return;  // it may be there the next time
  seen_ = now;
  const Animation& animation = *session->animation();
  Begin(animation, session->project(), motion.value()->frames.size());
  std::optional<DynamicsWorkspace> ws;
  for (size_t i = 0; i < known_.size(); ++i) {
    const MotionFrame& frame = motion.value()->frames[i];
    if (known_[i] && known_[i]->q == frame.q && known_[i]->X_WR == frame.X_WR) continue;
    known_[i].reset();
    if (most-- <= 0) continue;
    if (!ws) ws.emplace(*figure_);
    known_[i] = LookAt(frame, &*ws);
  }
  is_done_ = most >= 0;
  Collect(animation.placements, animation.first_frame);
}

void GroundWatch::Begin(const Animation& animation, const Project& project, size_t num_frames) {
  std::vector<SceneObject> scene = animation.scene;
  std::erase_if(scene, [&](const SceneObject& object) { return IsHeldOnTo(object, project); });
  if (figure_ != animation.figure || scene_ != scene) known_.clear();
  figure_ = animation.figure;
  scene_ = std::move(scene);
  known_.resize(num_frames);
}

GroundWatch::Known GroundWatch::LookAt(const MotionFrame& frame, DynamicsWorkspace* ws) const {
  Known known = {frame.q, frame.X_WR, 0.0, GroupIndex()};
  ComputePositions(*figure_, frame.X_WR, frame.q, ws);
  const std::optional<Contact> contact = NearestContact(*figure_, scene_, *ws);
  if (!contact || contact->clearance > -kDeep) return known;
  known.depth = -contact->clearance;
  if (!figure_->groups().empty()) known.joint = NearestGroup(*figure_, *ws, contact->point);
  return known;
}

// Frames in a row become one.
void GroundWatch::Collect(const std::vector<PlacementSpan>& placements, int first_frame) {
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

}  // namespace hazumi::ui
