#include "engine/bake/walk/paper_drives.h"

#include "engine/bake/walk/drive_curves.h"

namespace hazumi {

void PaperDrives::SetRegions(const std::vector<int>& regions) {
  curves_.SetRegions(regions);
  springs_.clear();
  balls_.clear();
  forward_.reset();
  const Figure& figure = context_.poses.figure();
  for (const DriveCurves::Entry& entry : curves_.entries()) {
    springs_.emplace_back();
    if (entry.drive->kind != DriveKind::kSpring) continue;
    const DynamicsRegion& region = context_.animation.regions[entry.region];
    if (entry.drive->feed_forward && !forward_) {
      forward_ = std::make_unique<FeedForward>(context_.animation, figure, regions);
    }
    springs_.back() = SpringOf(*entry.drive, entry.joint, region, figure,
                               context_.starts.at(entry.region), context_.animation.rate);
    const JointGroup& group = figure.group(figure.joint(entry.joint).group);
    if (entry.joint != group.first) continue;
    const auto axes = BallAxesOf(figure, group);
    if (axes) balls_.emplace(group.first, Ball{*axes, springs_.size() - 1});
  }
}

FigureMotion PaperDrives::KeyedAt(const FigureMotion& motion) {
  FigureMotion keyed = motion;
  const auto set = [&](JointIndex joint, const CurveSample& sample) {
    const int j = joint.value();
    keyed.q[j] = sample.value;
    keyed.qd[j] = sample.rate;
    keyed.qdd[j] = sample.acceleration;
  };
  const std::vector<char>& free = context_.poses.free();
  for (size_t j = 0; j < free.size() && forward_; ++j) {
    const JointIndex joint(static_cast<int>(j));
    if (free[j]) set(joint, context_.poses.curves().joint(joint).At(motion.frame));
  }
  for (DriveCurves::Entry& entry : curves_.entries()) {
    if (entry.drive->kind != DriveKind::kSpring) continue;
    CurveTrack* track = curves_.TrackOf(&entry);
    set(entry.joint, track ? track->At(motion.frame) : CurveSample{*entry.constant, 0.0, 0.0});
  }
  return keyed;
}

SpringNow PaperDrives::Now(size_t entry, double frame) {
  DriveCurves::Entry& of = curves_.entries()[entry];
  return NowOf(springs_[entry], of.frequency ? of.frequency->At(frame).value : 0.0,
               of.strength ? of.strength->At(frame).value : 0.0);
}

VecX PaperDrives::TorquesAt(const FigureMotion& motion) {
  const int n = context_.poses.figure().num_joints();
  const FigureMotion keyed = KeyedAt(motion);
  const VecX &ref = keyed.q, &ref_rate = keyed.qd;
  ForwardTorques ahead{VecX::Zero(n), VecX::Zero(n)};
  if (forward_) ahead = forward_->Of(keyed, context_.poses.placement().hold());
  VecX torques = VecX::Zero(n);
  for (size_t i = 0; i < springs_.size(); ++i) {
    DriveCurves::Entry& entry = curves_.entries()[i];
    const int j = entry.joint.value();
    torques[j] = entry.drive->kind == DriveKind::kTorque
                     ? curves_.TrackOf(&entry)->At(motion.frame).value
                     : TorqueOf(springs_[i], Now(i, motion.frame), {motion.q[j], motion.qd[j]},
                                {ref[j], ref_rate[j]}, ahead.torques[j]);
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
    torques.segment<3>(first.value()) =
        A.transpose() * MomentOf(springs_[ball.entry], Now(ball.entry, motion.frame), E, w - w_ref,
                                 of(ahead.moments));
  }
  return torques;
}

}  // namespace hazumi
