#include "engine/exchange/import/joint_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/text.h"

namespace hazumi {

namespace {

constexpr EulerAxes kRootAxes = {2, 1, 0};
constexpr double kStill = 1e-5;  // of a translation [m]
constexpr double kSameScale = 1e-4;

// Least and greatest by component.
struct Range {
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

Range RangeOf(const std::vector<Vec3>& values) {
  Range range;
  for (const Vec3& value : values) range.Take(value);
  return range;
}

class Planner {
 public:
  Planner(const Character& character, const Skeleton& skeleton, const Clip* clip,
          const WorldFrame& world, ImportReport* report)
      : character_(character),
        skeleton_(skeleton),
        clip_(clip),
        world_(world),
        report_(report),
        num_frames_(clip ? clip->num_frames : 1) {}

  FigurePlan Plan() {
    for (size_t k = 0; k < skeleton_.bones.size(); ++k) plan_.joints.push_back(Joint(k));
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
    joint.name = bone(k).name;
    joint.parent = skeleton_.bones[k].parent;
    if (joint.parent < 0) return joint;
    const BonePose& parent = skeleton_.rest[bone(k).parent];
    const bool on_root = joint.parent == 0;
    const Mat3 above = on_root ? parent.R : Mat3(Mat3::Identity());
    joint.orientation = world_.Turned(above * bone(k).rest.R);
    joint.offset = world_.Placed(above * (parent.scale * Offset(k)));
    Turn(k, &joint);
    return joint;
  }

  // In the parent's frame, without what moves it there: its mean.
  Vec3 Offset(size_t k) {
    const BoneTrack& moved = track(k);
    const Range scales = RangeOf(moved.scales);
    if (scales.width() > kSameScale) Drop(k, "scale", scales, 1.0, "");
    if (moved.translations.empty()) return bone(k).rest.p;
    const Range range = RangeOf(moved.translations);
    const double scale = skeleton_.rest[bone(k).parent].scale;
    if (range.width() * world_.metres * scale <= kStill) return range.sum / range.num;
    Drop(k, "translation", range, 100.0 * world_.metres * scale, " cm");
    return range.sum / range.num;
  }

  void Drop(size_t k, const char* what, const Range& range, double unit, const char* unit_name) {
    std::string message = std::string(what) + " in its parent is dropped:";
    for (int i = 0; i < 3; ++i) {
      if (range.high[i] - range.low[i] <= 1e-12) continue;
      message += std::string(" ") + "xyz"[i] + " " + FormatShort(unit * range.low[i]) + " to " +
                 FormatShort(unit * range.high[i]) + unit_name;
    }
    report_->warnings.push_back({bone(k).name, message + "; joints only turn"});
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
    joint->angles = has_angles ? turned.angles : Decomposed(k, axes);
    for (int i = 0; i < 3; ++i) joint->axes[i] = WorldAxis(axes[i]);
  }

  // The world's axis that one of the file is.
  int WorldAxis(int axis) const {
    Vec3::Index along = 0;
    world_.C.col(axis).maxCoeff(&along);
    return static_cast<int>(along);
  }

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
    const Mat3 rest = skeleton_.rest[root].R;
    Vec3 previous = Vec3::Zero();
    for (int f = 0; f < num_frames_; ++f) {
      const BonePose pose = PosesAt(character_, clip_, f)[root];
      plan_.root_position.push_back(world_.Placed(pose.p));
      previous = EulerAnglesNear(world_.Turned(pose.R * rest.transpose()), kRootAxes, previous);
      plan_.root_angles.push_back(previous);
    }
  }

  const Character& character_;
  const Skeleton& skeleton_;
  const Clip* clip_;
  const WorldFrame& world_;
  ImportReport* report_;
  int num_frames_;
  FigurePlan plan_;
};

}  // namespace

std::string HingeName(int axis) { return std::string(1, "xyz"[axis]); }

FigurePlan PlanFigure(const Character& character, const Skeleton& skeleton, const Clip* clip,
                      const WorldFrame& world, ImportReport* report) {
  return Planner(character, skeleton, clip, world, report).Plan();
}

std::vector<Vec3> PositionsOf(const FigurePlan& plan, int frame) {
  std::vector<Vec3> p(plan.joints.size());
  std::vector<Mat3> R(plan.joints.size());
  p[0] = plan.root_position[frame];
  R[0] = EulerRotation(kRootAxes, plan.root_angles[frame]);
  for (size_t k = 1; k < p.size(); ++k) {
    const PlannedJoint& joint = plan.joints[k];
    p[k] = p[joint.parent] + R[joint.parent] * joint.offset;
    R[k] = R[joint.parent] * joint.orientation * EulerRotation(joint.axes, joint.angles[frame]);
  }
  return p;
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
