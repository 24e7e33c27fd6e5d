#include "engine/exchange/import/joint_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/text.h"
#include "engine/body/body_axes.h"
#include "engine/exchange/import/import_names.h"

namespace hazumi {

namespace {

constexpr EulerAxes kRootAxes = {2, 1, 0};
constexpr double kStill = 1e-5;  // of a translation [m]
constexpr double kSameScale = 1e-4;
constexpr double kJump = std::numbers::pi / 2.0;  // of an angle, from frame to frame

// Least and greatest by component.
struct HingeRange {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  Vec3 sum = Vec3::Zero();
  int num = 0;
  void Take(const Vec3& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
    sum += v;
    ++num;
  }
  double width() const { return num == 0 ? 0.0 : (high - low).maxCoeff(); }
};

HingeRange RangeOf(const std::vector<Vec3>& values) {
  HingeRange range;
  for (const Vec3& value : values) range.Take(value);
  return range;
}

class Planner {
 public:
  Planner(const Character& character, const Skeleton& skeleton, const Clip* clip,
          const WorldFrame& world, const ImportOptions& options, ImportReport* report)
      : character_(character),
        skeleton_(skeleton),
        clip_(clip),
        world_(world),
        options_(options),
        report_(report),
        num_frames_(clip ? clip->num_frames : 1) {}

  FigurePlan Plan() {
    plan_.has_clip = clip_ != nullptr;
    std::vector<std::string> names;
    for (size_t k = 0; k < skeleton_.bones.size(); ++k) names.push_back(bone(k).name);
    names = FigureNames(names, report_);
    for (size_t k = 0; k < skeleton_.bones.size(); ++k) {
      plan_.joints.push_back(Joint(k));
      plan_.joints.back().name = names[k];
    }
    if (options_.hinges == ImportHinges::kBody && !skeleton_.has_four_legs) SetBodyHinges();
    PlaceRoot();
    return std::move(plan_);
  }

 private:
  const Bone& bone(size_t k) const { return character_.bones[skeleton_.bones[k].bone]; }
  const BoneTrack& track(size_t k) const {
    static const BoneTrack kNone;
    return clip_ ? clip_->tracks[skeleton_.bones[k].bone] : kNone;
  }

  PlannedJoint Joint(size_t k) {
    PlannedJoint joint;
    joint.parent = skeleton_.bones[k].parent;
    if (joint.parent < 0) return joint;
    const BonePose& parent = skeleton_.rest[bone(k).parent];
    const bool on_root = joint.parent == 0;
    const Mat3 above = on_root ? parent.R : Mat3(Mat3::Identity());
    const Mat3 turn = parent.is_even()
                          ? bone(k).rest.R
                          : Mat3(parent.R.transpose() * skeleton_.rest[skeleton_.bones[k].bone].R);
    const Vec3 offset = parent.stretch * Offset(k);
    joint.orientation = on_root ? world_.AxesInWorld(above * turn) : world_.Turned(turn);
    joint.offset = on_root ? world_.Placed(above * offset) : world_.Way(offset);
    Turn(k, &joint);
    return joint;
  }

  // In the parent's frame, without what moves it there: its mean.
  Vec3 Offset(size_t k) {
    const BoneTrack& moved = track(k);
    const HingeRange scales = RangeOf(moved.scales);
    if (scales.width() > kSameScale) Drop(bone(k), "scale", scales, 1.0, "");
    if (moved.translations.empty()) return bone(k).rest.p;
    const HingeRange range = RangeOf(moved.translations);
    const double scale = skeleton_.rest[bone(k).parent].stretch.diagonal().mean();
    if (range.width() * world_.metres * scale <= kStill) return range.sum / range.num;
    Drop(bone(k), "translation", range, 100.0 * world_.metres * scale, " cm");
    return range.sum / range.num;
  }

  void Drop(const Bone& bone, const char* what, const HingeRange& range, double unit,
            const char* unit_name) {
    std::string message = std::string(what) + " in its parent is dropped:";
    for (int i = 0; i < 3; ++i) {
      if (range.high[i] - range.low[i] <= 1e-12) continue;
      const auto text = [unit](double value) {
        return FormatShort(std::round(1e3 * unit * value) / 1e3 + 0.0);
      };
      message += std::string(" ") + "xyz"[i] + " " + text(range.low[i]) + " to " +
                 text(range.high[i]) + unit_name;
    }
    report_->warnings.push_back({bone.name, message + "; joints only turn"});
  }

  // Angles as the file has them, if its order is known, else those of the order whose middle angle
  // stays farthest from a right angle, where the outer two could not be told apart.
  void Turn(size_t k, PlannedJoint* joint) {
    const BoneTrack& turned = track(k);
    EulerAxes axes = {2, 0, 1};
    const auto stated = EulerAxesOf(bone(k).rotation_order);
    const bool has_angles = !turned.angles.empty() && bone(k).rest.R.isIdentity(0.0);
    if (stated && !bone(k).rotation_order.empty()) {
      axes = *stated;
      joint->num_hinges = static_cast<int>(bone(k).rotation_order.size());
    } else if (!turned.rotations.empty()) {
      axes = BestAxes(k);
    }
    joint->angles =
        has_angles ? Continuous(turned.angles, axes, joint->num_hinges) : Decomposed(k, axes);
    for (int i = 0; i < 3; ++i) joint->axes[i] = WorldAxis(axes[i]);
  }

  // The parts of a body get its hinges. With A a bone's body axes in its own frame, B its axes at
  // rest and S its body axes at rest, both in the root's frame, and p its parent:
  //   A = B^T S,   orientation = A_p A^T,   E = A_p^T R A,   at rest E = S_p^T S.
  void SetBodyHinges() {
    const std::vector<Pose> rest = RestBodies(plan_);
    std::vector<RestBone> bones;
    std::vector<BodyPlace> places;
    for (size_t k = 0; k < rest.size(); ++k) {
      places.push_back(skeleton_.bones[k].place);
      bones.push_back({skeleton_.bones[k].place, plan_.joints[k].parent, rest[k], EndOf(k, rest)});
    }
    const std::vector<Mat3> S = BodyAxesOf(bones);
    std::vector<Mat3> A;
    for (size_t k = 0; k < rest.size(); ++k) A.push_back(rest[k].R.transpose() * S[k]);
    for (size_t k = 1; k < rest.size(); ++k) {
      PlannedJoint& joint = plan_.joints[k];
      joint.body = BodyHingesOf(places[k], PartOfRow(places, k));
      if (!joint.body) continue;
      const Mat3 before = joint.orientation, A_p = A[static_cast<size_t>(joint.parent)];
      const auto angles = [&](const Mat3& R, const Vec3& previous) -> Vec3 {
        const Mat3 E = A_p.transpose() * R * A[k];
        return joint.signs.cwiseProduct(
            EulerAnglesNear(E, joint.axes, joint.signs.cwiseProduct(previous)));
      };
      for (int h = 0; h < 3; ++h) {
        joint.axes[h] = (*joint.body)[static_cast<size_t>(h)].axis;
        joint.signs[h] = (*joint.body)[static_cast<size_t>(h)].sign;
      }
      joint.num_hinges = 3;
      joint.rest = angles(before, Vec3::Zero());
      Vec3 previous = joint.rest;
      for (int f = 0; f < static_cast<int>(joint.angles.size()); ++f) {
        const Mat3 R =
            track(k).rotations.empty() ? before : Mat3(before * world_.Turned(Turned(k, f)));
        joint.angles[static_cast<size_t>(f)] = previous = angles(R, previous);
      }
      for (int h = 0; h < 3; ++h) HoldStill(h, &joint);
      joint.frame = A[k];
      joint.orientation = A_p * A[k].transpose();
    }
  }

  // A hinge that is fixed is exactly so.
  static void HoldStill(int h, PlannedJoint* joint) {
    HingeRange range = RangeOf(joint->angles);
    const AngleRange angles = {range.low[h], range.high[h]};
    if (joint->angles.empty() || !IsFixed((*joint->body)[static_cast<size_t>(h)], angles)) return;
    for (Vec3& at : joint->angles) at[h] = 0.5 * (angles.low + angles.high);
  }

  std::optional<Vec3> EndOf(size_t k, const std::vector<Pose>& rest) const {
    const std::optional<Vec3>& end = bone(k).end_site;
    if (!end) return std::nullopt;
    return rest[k] * world_.Way(skeleton_.rest[skeleton_.bones[k].bone].stretch * *end);
  }

  // The file's angles, those that jump between two frames, as at 180 degrees, replaced by others
  // that say the same and do not: what lies between two keys follows them.
  static std::vector<Vec3> Continuous(std::vector<Vec3> angles, const EulerAxes& axes,
                                      int num_hinges) {
    for (size_t f = 1; f < angles.size(); ++f) {
      const Vec3& before = angles[f - 1];
      if ((angles[f] - before).cwiseAbs().maxCoeff() <= kJump) continue;
      if (num_hinges == 3) {
        angles[f] = EulerAnglesNear(EulerRotation(axes, angles[f]), axes, before);
        continue;
      }
      for (int i = 0; i < num_hinges; ++i) {
        const double turns = std::round((before[i] - angles[f][i]) / (2.0 * std::numbers::pi));
        angles[f][i] += 2.0 * std::numbers::pi * turns;
      }
    }
    return angles;
  }

  // The world's axis that one of the file is.
  int WorldAxis(int axis) const {
    Vec3::Index along = 0;
    world_.C.col(axis).maxCoeff(&along);
    return static_cast<int>(along);
  }

  // From rest, in the bone's own frame.
  Mat3 Turned(size_t k, int frame) const {
    return bone(k).rest.R.transpose() * track(k).rotations[frame].toRotationMatrix();
  }

  std::vector<Vec3> Decomposed(size_t k, const EulerAxes& axes) const {
    std::vector<Vec3> angles(num_frames_, Vec3::Zero());
    if (track(k).rotations.empty()) return angles;
    Vec3 previous = Vec3::Zero();
    for (int f = 0; f < num_frames_; ++f) {
      angles[f] = previous = EulerAnglesNear(Turned(k, f), axes, previous);
    }
    return angles;
  }

  EulerAxes BestAxes(size_t k) const {
    constexpr EulerAxes kOrders[] = {{2, 0, 1}, {2, 1, 0}, {1, 0, 2},
                                     {1, 2, 0}, {0, 1, 2}, {0, 2, 1}};
    EulerAxes best = kOrders[0];
    double least = std::numeric_limits<double>::infinity();
    for (const EulerAxes& axes : kOrders) {
      double sine = 0.0;  // of the middle angle: R = R_a R_b R_c has it at row a, column c
      for (int f = 0; f < num_frames_; ++f) {
        sine = std::max(sine, std::abs(Turned(k, f)(axes[0], axes[2])));
      }
      if (sine >= least - 1e-3) continue;
      least = sine;
      best = axes;
    }
    return best;
  }

  void PlaceRoot() {
    const int root = skeleton_.bones[0].bone;
    for (int b = root; clip_ && b >= 0; b = character_.bones[b].parent) {
      const HingeRange scales = RangeOf(clip_->tracks[b].scales);
      if (scales.width() > kSameScale) Drop(character_.bones[b], "scale", scales, 1.0, "");
    }
    const Mat3 rest = skeleton_.rest[root].R;
    Vec3 previous = Vec3::Zero();
    for (int f = 0; f < num_frames_; ++f) {
      const BonePose pose = PosesAt(character_, clip_, f)[root];
      plan_.root_position.push_back(world_.Placed(pose.p));
      previous =
          EulerAnglesNear(world_.TurnedInWorld(pose.R * rest.transpose()), kRootAxes, previous);
      plan_.root_angles.push_back(previous);
    }
  }

  const Character& character_;
  const Skeleton& skeleton_;
  const Clip* clip_;
  const WorldFrame& world_;
  const ImportOptions& options_;
  ImportReport* report_;
  int num_frames_;
  FigurePlan plan_;
};

}  // namespace

FigurePlan PlanFigure(const Character& character, const Skeleton& skeleton, const Clip* clip,
                      const WorldFrame& world, const ImportOptions& options, ImportReport* report) {
  return Planner(character, skeleton, clip, world, options, report).Plan();
}

std::string PlannedJoint::HingeName(int hinge) const {
  const std::string own =
      body ? (*body)[static_cast<size_t>(hinge)].name : hazumi::HingeName(axes[hinge]);
  return name + "_" + own;
}

Mat3 PlannedJoint::RotationAt(const Vec3& turned) const {
  if (!body) return orientation * EulerRotation(axes, turned);
  return orientation * frame * EulerRotation(axes, signs.cwiseProduct(turned)) * frame.transpose();
}

std::vector<Pose> BodiesOf(const FigurePlan& plan, int frame) {
  std::vector<Pose> X_WB(plan.joints.size());
  X_WB[0] = {EulerRotation(kRootAxes, plan.root_angles[frame]), plan.root_position[frame]};
  for (size_t k = 1; k < X_WB.size(); ++k) {
    const PlannedJoint& joint = plan.joints[k];
    X_WB[k] = X_WB[joint.parent] * Pose{joint.RotationAt(joint.angles[frame]), joint.offset};
  }
  return X_WB;
}

std::vector<Pose> RestBodies(const FigurePlan& plan) {
  std::vector<Pose> X_RB(plan.joints.size());
  for (size_t k = 1; k < X_RB.size(); ++k) {
    const PlannedJoint& joint = plan.joints[k];
    X_RB[k] = X_RB[joint.parent] * Pose{joint.RotationAt(joint.rest), joint.offset};
  }
  return X_RB;
}

std::vector<Vec3> PositionsOf(const FigurePlan& plan, int frame) {
  std::vector<Vec3> positions;
  positions.reserve(plan.joints.size());
  for (const Pose& X_WB : BodiesOf(plan, frame)) positions.push_back(X_WB.p);
  return positions;
}

std::vector<Vec3> FilePositions(const Character& character, const Skeleton& skeleton,
                                const Clip* clip, const WorldFrame& world, int frame) {
  const std::vector<BonePose> poses = PosesAt(character, clip, frame);
  std::vector<Vec3> positions;
  positions.reserve(skeleton.bones.size());
  for (const KeptBone& kept : skeleton.bones) positions.push_back(world.Placed(poses[kept.bone].p));
  return positions;
}

}  // namespace hazumi
