#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/dynamics/workspace.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// The figure at one frame, in the world.
class PosedFigure {
 public:
  // `hidden`: hinges, or the root; a joint is hidden when all of its hinges are.
  PosedFigure(const Figure& figure, const MotionFrame& frame,
              const std::set<std::string>& hidden = {});

  const Figure& figure() const { return *figure_; }
  const MotionFrame& frame() const { return *frame_; }
  // Of the body moved by a hinge; an invalid one: of the root's.
  hazumi::Pose PoseOf(JointIndex hinge) const;
  Vec3 CenterOf(GroupIndex joint) const { return ws_.body(figure_->group(joint).first).p; }
  Vec3 MiddleOf(const std::vector<GroupIndex>& joints) const;
  // Of a hinge, unit.
  Vec3 AxisOf(JointIndex hinge) const { return ws_.body(hinge).axis; }
  double angle(JointIndex hinge) const { return frame_->q[hinge.value()]; }  // [rad]
  bool is_root_hidden() const { return is_root_hidden_; }
  bool IsHidden(GroupIndex joint) const { return is_hidden_[joint.value()]; }
  // Where the limb beyond a joint points, unit: to the next joint, or to the end of its link.
  Vec3 LimbOf(GroupIndex joint) const;

 private:
  const Figure* figure_;
  const MotionFrame* frame_;
  DynamicsWorkspace ws_;
  std::vector<bool> is_hidden_;  // by joint
  bool is_root_hidden_;
};

// At the current frame, as it is shown; none if the project cannot be animated. Valid until the
// next edit.
std::optional<PosedFigure> PoseNow(edit::Session* session);

// Joints of which at least one hinge is selected, in the figure's order.
std::vector<GroupIndex> SelectedJoints(const edit::Session& session);
// Of a joint, those that can turn and, if some of its hinges are selected, are.
std::vector<JointIndex> TurnableHinges(const edit::Session& session, GroupIndex joint);

// Selected joints of which at least one hinge can turn.
std::vector<GroupIndex> TurnableJoints(const edit::Session& session);

// Joints that inverse kinematics can drag usefully, as two joints or more of a limb carry them and
// nothing else: hands and feet.
std::vector<GroupIndex> HandleJoints(const Figure& figure);

}  // namespace hazumi::ui
