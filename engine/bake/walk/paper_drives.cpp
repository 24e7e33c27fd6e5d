#include "engine/bake/walk/paper_drives.h"

#include "engine/bake/walk/spring_of.h"

namespace hazumi {

void PaperDrives::SetRegions(const std::vector<int>& regions) {
  curves_.SetRegions(regions);
  springs_.clear();
  balls_.clear();
  const Figure& figure = context_.poses.figure();
  for (const DriveCurves::Entry& entry : curves_.entries()) {
    springs_.emplace_back();
    if (entry.drive->kind != DriveKind::kSpring) continue;
    const DynamicsRegion& region = context_.animation.regions[entry.region];
    springs_.back() =
        SpringOf(*entry.drive, entry.joint, region, figure, context_.starts.at(entry.region));
    const JointGroup& group = figure.group(figure.joint(entry.joint).group);
    if (entry.joint != group.first) continue;
    const auto axes = BallAxesOf(figure, group);
    if (axes) balls_.emplace(group.first, Ball{*axes, springs_.back()});
  }
}

VecX PaperDrives::TorquesAt(const FigureMotion& motion) {
  const Figure& figure = context_.poses.figure();
  VecX torques = VecX::Zero(figure.num_joints()), ref = torques, ref_rate = torques;
  for (size_t i = 0; i < springs_.size(); ++i) {
    DriveCurves::Entry& entry = curves_.entries()[i];
    const int j = entry.joint.value();
    CurveTrack* track = curves_.TrackOf(&entry);
    const CurveSample now =
        track ? track->At(motion.frame) : CurveSample{*entry.constant, 0.0, 0.0};
    ref[j] = now.value;
    ref_rate[j] = now.rate;
    torques[j] = entry.drive->kind == DriveKind::kTorque
                     ? now.value
                     : TorqueOf(springs_[i], {motion.q[j], motion.qd[j]}, {ref[j], ref_rate[j]});
  }
  // Of a ball joint hinge i gets a_i . M.
  for (const auto& [first, ball] : balls_) {
    const auto of = [first = first.value()](const VecX& all) -> Vec3 {
      return all.segment<3>(first);
    };
    const HingeTriple& triple = ball.axes.triple;
    const Mat3 A = triple.AxesInBody(of(motion.q));
    const Mat3 E = triple.Rotation(of(ref)).transpose() * triple.Rotation(of(motion.q));
    const Vec3 w = A * of(motion.qd);
    const Vec3 w_ref = E.transpose() * (triple.AxesInBody(of(ref)) * of(ref_rate));
    torques.segment<3>(first.value()) = A.transpose() * MomentOf(ball.spring, E, w - w_ref);
  }
  return torques;
}

}  // namespace hazumi
