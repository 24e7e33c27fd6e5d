#include "ui/panels/viewport/figure.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "ui/edit/operators/pose/limb_chain.h"

namespace hazumi::ui {

PosedFigure::PosedFigure(const Figure& figure, const MotionFrame& frame,
                         const std::set<std::string>& hidden)
    : figure_(&figure),
      frame_(&frame),
      ws_(figure),
      is_hidden_(figure.groups().size(), true),
      is_root_hidden_(hidden.contains(figure.root_name())) {
  ComputePositions(figure, frame.X_WR, frame.q, &ws_);
  for (const Joint& hinge : figure.joints()) {
    if (!hidden.contains(hinge.name)) is_hidden_[hinge.group.value()] = false;
  }
}

hazumi::Pose PosedFigure::PoseOf(JointIndex hinge) const {
  if (!hinge.is_valid()) return frame_->X_WR;
  return {ws_.body(hinge).R, ws_.body(hinge).p};
}

Vec3 PosedFigure::MiddleOf(const std::vector<GroupIndex>& joints) const {
  Vec3 sum = Vec3::Zero();
  for (const GroupIndex joint : joints) sum += CenterOf(joint);
  return sum / static_cast<double>(joints.size());
}

Vec3 PosedFigure::LimbOf(GroupIndex joint) const {
  const JointIndex last = figure_->group(joint).last();
  Vec3 end = Vec3::Zero();  // in the frame of `last`
  for (const Link& link : figure_->links()) {
    if (link.joint != last) continue;
    for (const Vec3& p : {link.capsule.a, link.capsule.b}) {
      if (p.norm() > end.norm()) end = p;
    }
  }
  Vec3 limb = PoseOf(last).R * end;
  const std::vector<GroupIndex> children = ChildrenOf(last, *figure_);
  if (children.size() == 1) limb = CenterOf(children[0]) - CenterOf(joint);
  return limb.norm() > 1e-9 ? Vec3(limb.normalized()) : Vec3(PoseOf(last).R.col(2));
}

std::optional<PosedFigure> PoseNow(edit::Session* session) {
  const Result<const MotionFrame*> now = session->ShownFrame();
  if (!now.ok()) return std::nullopt;
  return PosedFigure(session->figure(), *now.value(), session->hidden_joints());
}

std::vector<GroupIndex> SelectedJoints(const edit::Session& session) {
  const Figure& figure = session.figure();
  std::vector<GroupIndex> joints;
  for (const Joint& hinge : figure.joints()) {
    if (!session.selected_joints().contains(hinge.name)) continue;
    if (joints.empty() || joints.back() != hinge.group) joints.push_back(hinge.group);
  }
  return joints;
}

std::vector<JointIndex> TurnableHinges(const edit::Session& session, GroupIndex joint) {
  const Figure& figure = session.figure();
  const JointGroup& group = figure.group(joint);
  std::vector<JointIndex> all, chosen;
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    if (figure.joints()[j].is_fixed()) continue;
    all.push_back(JointIndex(j));
    if (session.selected_joints().contains(figure.joints()[j].name)) chosen.push_back(all.back());
  }
  return chosen.empty() ? all : chosen;
}

std::vector<GroupIndex> TurnableJoints(const edit::Session& session) {
  std::vector<GroupIndex> joints = SelectedJoints(session);
  std::erase_if(joints, [&](GroupIndex joint) { return TurnableHinges(session, joint).empty(); });
  return joints;
}

std::vector<GroupIndex> HandleJoints(const Figure& figure) {
  std::vector<GroupIndex> handles;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    if (edit::EndsLimb(GroupIndex(g), figure)) handles.push_back(GroupIndex(g));
  }
  return handles;
}

}  // namespace hazumi::ui
