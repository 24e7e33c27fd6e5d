// With F C the turn from the file's axes to the world's (world_frame.h), R_k and P_k rotation and
// rest rotation of bone k in the file's world, and p its parent, a figure of an import has
//   R_WB(root) = F C R_root P_root^T (F C)^T,   R_WB(k) = F C R_k C^T,
// so that the turn of a body in its parent, Q = R_WB(p)^T R_WB(k), gives the bone's rotation
//   R_root = (F C)^T R_WB F C P_root,
//   R_k = R_p C^T Q C,   below the root R_k = R_root P_root^T (F C)^T Q C.
// A turn that is as at the import keeps the file's R_p^T R_k, to the last bit of what is between.

#include "engine/exchange/onto/edited_bones.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/text.h"
#include "engine/exchange/import/import_names.h"
#include "engine/exchange/import/import_plan.h"

namespace hazumi {

namespace {

constexpr double kSameTurn = 1e-6;   // [rad]
constexpr double kSamePlace = 1e-6;  // [m]
constexpr double kTurned = 1e-7;     // of a node, beyond rounding [rad]
constexpr int kMostSteps = 50;       // towards a turn below uneven scales
constexpr double kSolved = 1e-10;    // of such a turn [rad]

double AngleBetween(const Mat3& a, const Mat3& b) {
  return Eigen::Quaterniond(a).angularDistance(Eigen::Quaterniond(b));
}

Mat3 NearestRotation(const Mat3& A) {
  const Eigen::JacobiSVD<Mat3> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 R = svd.matrixU() * svd.matrixV().transpose();
  return R.determinant() < 0.0 ? Mat3(-R) : R;
}

// A bone in its parent, as the file has it.
struct Local {
  Mat3 R;
  Vec3 p, scale;
};

Local LocalAt(const Bone& bone, const BoneTrack& track, size_t frame) {
  return {track.rotations.empty() ? bone.rest.R : track.rotations[frame].toRotationMatrix(),
          track.translations.empty() ? bone.rest.p : track.translations[frame],
          track.scales.empty() ? bone.rest_scale : track.scales[frame]};
}

class Edits {
 public:
  Edits(const Character& source, ImportPlan plan, const Figure& figure, const Motion& motion)
      : source_(source),
        plan_(std::move(plan)),
        figure_(figure),
        motion_(motion),
        FC_(plan_.world.F * plan_.world.C) {}

  Result<EditedClip> Find() {
    if (auto error = Match()) return *error;
    Begin();
    for (int i = 0; i < clip_.num_frames; ++i) {
      if (auto error = AddFrame(clip_.first + i)) return *error;
    }
    KeepChanged();
    return std::move(clip_);
  }

 private:
  Error Foreign(const std::string& message) const {
    return {ErrorCode::kSemantics, "", "",
            message + "; the figure was not imported from this file, or not with these options"};
  }

  // Finds each bone's group of the figure and its number in the file.
  std::optional<Error> Match() {
    std::map<std::string, int> groups, bones;
    for (size_t g = 0; g < figure_.groups().size(); ++g)
      groups[figure_.groups()[g].name] = static_cast<int>(g);
    for (size_t b = 0; b < source_.bones.size(); ++b)
      bones[source_.bones[b].name] = static_cast<int>(b);
    const std::vector<PlannedJoint>& joints = plan_.plan.joints;
    for (size_t k = 0; k < joints.size(); ++k) {
      const int hung = plan_.skeleton.bones[k].bone;
      own_.push_back(bones.at(plan_.character.bones[static_cast<size_t>(hung)].name));
      group_.push_back(-1);
      if (k == 0) {
        if (figure_.root_name() == joints[0].name) continue;
        return Foreign("its root is " + Quoted(figure_.root_name()) + ", the file's " +
                       Quoted(joints[0].name));
      }
      const auto found = groups.find(joints[k].name);
      if (found == groups.end()) return Foreign("it has no joint " + Quoted(joints[k].name));
      group_.back() = found->second;
      if (ParentName(found->second) != joints[static_cast<size_t>(joints[k].parent)].name)
        return Foreign(Quoted(joints[k].name) + " hangs on another joint");
    }
    return std::nullopt;
  }

  const JointGroup& group(size_t k) const {
    return figure_.groups()[static_cast<size_t>(group_[k])];
  }

  const std::string& ParentName(int g) const {
    const JointGroup& of = figure_.groups()[static_cast<size_t>(g)];
    const JointIndex parent = figure_.joint(of.first).parent;
    return parent.is_valid() ? figure_.group(figure_.joint(parent).group).name
                             : figure_.root_name();
  }

  const Clip* clip() const { return plan_.clip ? &source_.clips[*plan_.clip] : nullptr; }

  void Begin() {
    const Clip* from = clip();
    clip_.num_source_frames = from ? from->num_frames : 0;
    clip_.seconds_per_frame = motion_.rate.seconds_per_frame();
    if (from) {
      clip_.index = from->index;
      clip_.name = from->name;
      clip_.start_s = from->start_s;
    }
    const int first = motion_.frames.front().frame, last = motion_.frames.back().frame;
    clip_.first = std::min(first, from ? 0 : first);
    clip_.num_frames = std::max(last, from ? from->num_frames - 1 : last) - clip_.first + 1;
    clip_.bones.resize(own_.size());
    turns_.resize(own_.size());
    moves_.resize(own_.size());
    for (size_t k = 0; k < own_.size(); ++k) {
      clip_.bones[k].name = bone(k).name;
      clip_.bones[k].node = bone(k).source.node;
    }
  }

  const Bone& bone(size_t k) const { return source_.bones[static_cast<size_t>(own_[k])]; }

  const MotionFrame* MovedAt(int frame) const {
    const int at = frame - motion_.frames.front().frame;
    if (at < 0 || at >= static_cast<int>(motion_.frames.size())) return nullptr;
    return &motion_.frames[static_cast<size_t>(at)];
  }

  Mat3 TurnOf(const JointGroup& of, const VecX& q) const {
    Mat3 turn = figure_.joint(of.first).X_PJ.R;
    for (int j = of.first.value(); j <= of.last().value(); ++j)
      turn = turn * Eigen::AngleAxisd(q[j], figure_.joint(JointIndex(j)).axis).toRotationMatrix();
    return turn;
  }

  // Bodies that the motion turns or moves otherwise than the import's keys.
  std::optional<Error> AddFrame(int frame) {
    const int last = static_cast<int>(plan_.plan.root_position.size()) - 1;
    const int there = std::clamp(frame, 0, last);
    const std::vector<BonePose> before = PosesAt(source_, clip(), there);
    std::vector<BonePose> after = before;
    const MotionFrame* moved = MovedAt(frame);
    for (size_t k = 0; k < own_.size(); ++k) {
      const auto b = static_cast<size_t>(own_[k]);
      const int above = source_.bones[b].parent;
      const BonePose parent = above < 0 ? BonePose() : after[static_cast<size_t>(above)];
      static const BoneTrack kStill;
      const BoneTrack& track = clip() ? clip()->tracks[b] : kStill;
      const Local old = LocalAt(source_.bones[b], track, static_cast<size_t>(there));
      Local now = old;
      const BonePose target = TargetOf(k, moved, there, before, after);
      now.R = LocalTurn(parent, target.R, old);
      if (IsPlaced(k)) {
        const Mat3 A = parent.R * parent.stretch;
        now.p = A.inverse() * (target.p - parent.p);
        if ((now.p - old.p).norm() * plan_.world.metres <= kSamePlace) now.p = old.p;
      }
      after[b] = BelowPose(parent, now.R, now.p, now.scale);
      const Eigen::Matrix4d& between = track.above.empty()
                                           ? source_.bones[b].source.above
                                           : track.above[static_cast<size_t>(there)];
      if (auto error = Record(k, old, now, between)) return error;
    }
    return std::nullopt;
  }

  // Whether the figure places the bone otherwise than the file's hierarchy does: the root, and what
  // the import has hung on another bone.
  bool IsPlaced(size_t k) const {
    if (k == 0) return true;
    const int parent = own_[static_cast<size_t>(plan_.plan.joints[k].parent)];
    return bone(k).parent != parent;
  }

  // Rotation, and place of what is placed, in the world of the file.
  BonePose TargetOf(size_t k, const MotionFrame* moved, int there,
                    const std::vector<BonePose>& before, const std::vector<BonePose>& after) const {
    const auto b = static_cast<size_t>(own_[k]);
    BonePose target = before[b];
    if (k == 0) {
      if (!moved) return target;
      const Pose X_WB = BodyOfRoot(there);
      const Mat3& rest = plan_.skeleton.rest[static_cast<size_t>(plan_.skeleton.bones[0].bone)].R;
      if (AngleBetween(X_WB.R, moved->X_WR.R) > kSameTurn)
        target.R = FC_.transpose() * moved->X_WR.R * FC_ * rest;
      if ((X_WB.p - moved->X_WR.p).norm() > kSamePlace)
        target.p = FC_.transpose() * moved->X_WR.p / plan_.world.metres;
      return target;
    }
    const PlannedJoint& joint = plan_.plan.joints[k];
    const auto p = static_cast<size_t>(own_[static_cast<size_t>(joint.parent)]);
    target.R = after[p].R * before[p].R.transpose() * before[b].R;
    if (IsPlaced(k)) {
      const Mat3 A = before[p].R * before[p].stretch;
      target.p = after[p].At(A.inverse() * (before[b].p - before[p].p));
    }
    if (!moved) return target;
    const Mat3 as_imported = joint.RotationAt(joint.angles[static_cast<size_t>(there)]);
    const Mat3 Q = TurnOf(group(k), moved->q);
    if (AngleBetween(as_imported, Q) <= kSameTurn) return target;
    const Mat3 in_file = joint.parent == 0
                             ? Mat3(RestOfRoot().transpose() * FC_.transpose() * Q * plan_.world.C)
                             : Mat3(plan_.world.C.transpose() * Q * plan_.world.C);
    target.R = after[p].R * in_file;
    return target;
  }

  Pose BodyOfRoot(int frame) const {
    return {EulerRotation({2, 1, 0}, plan_.plan.root_angles[static_cast<size_t>(frame)]),
            plan_.plan.root_position[static_cast<size_t>(frame)]};
  }

  const Mat3& RestOfRoot() const {
    return plan_.skeleton.rest[static_cast<size_t>(plan_.skeleton.bones[0].bone)].R;
  }

  // The bone's turn in its parent that turns it so in the world. Below scales that are not even a
  // turn in the world depends on what is stretched how: by steps.
  Mat3 LocalTurn(const BonePose& parent, const Mat3& R, const Local& old) const {
    if (parent.is_even()) return parent.R.transpose() * R;
    Mat3 local = old.R;
    for (int step = 0; step < kMostSteps; ++step) {
      const Mat3 now = BelowPose(parent, local, old.p, old.scale).R;
      if (AngleBetween(now, R) < kSolved) break;
      local = NearestRotation(local * now.transpose() * R);
    }
    return local;
  }

  // `between`: nodes between the bone's and its parent's, which are no bones.
  std::optional<Error> Record(size_t k, const Local& old, const Local& now,
                              const Eigen::Matrix4d& between) {
    EditedBone& edited = clip_.bones[k];
    const Mat3 A = between.topLeftCorner<3, 3>();
    const Mat3 turn = A.isIdentity(0.0) ? A : NearestRotation(A);
    const Mat3 stretch = turn.transpose() * A;
    const bool is_changed = AngleBetween(old.R, now.R) > kTurned || old.p != now.p;
    const double scale = stretch.diagonal().mean();
    const bool is_even = (stretch - scale * Mat3::Identity()).cwiseAbs().maxCoeff() <= 1e-6 * scale;
    if (is_changed && !is_even) {
      return Error{ErrorCode::kSemantics, "", edited.name,
                   "hangs on a node that is scaled unevenly and is no bone: its turn cannot be "
                   "written; apply the scale in the program that the file comes from"};
    }
    Eigen::Quaterniond q(Mat3(turn.transpose() * now.R));
    q.normalize();
    if (!edited.rotations.empty() && q.dot(edited.rotations.back()) < 0.0) q.coeffs() = -q.coeffs();
    edited.rotations.push_back(q);
    const Vec3 offset = between.topRightCorner<3, 1>();
    edited.translations.push_back(A.inverse() * (now.p - offset));
    edited.is_changed.push_back(is_changed);
    turns_[k] |= AngleBetween(old.R, now.R) > kTurned;
    moves_[k] |= old.p != now.p;
    return std::nullopt;
  }

  void KeepChanged() {
    std::vector<EditedBone> kept;
    for (size_t k = 0; k < clip_.bones.size(); ++k) {
      EditedBone& edited = clip_.bones[k];
      if (!turns_[k]) edited.rotations.clear();
      if (!moves_[k]) edited.translations.clear();
      if (turns_[k] || moves_[k]) kept.push_back(std::move(edited));
    }
    clip_.bones = std::move(kept);
  }

  const Character& source_;
  const ImportPlan plan_;
  const Figure& figure_;
  const Motion& motion_;
  const Mat3 FC_;
  std::vector<int> own_, group_;  // by kept bone: bone of the source; group of the figure, or -1
  std::vector<char> turns_, moves_;
  EditedClip clip_;
};

}  // namespace

Result<EditedClip> EditedBonesOf(const Character& source, const ImportOptions& how,
                                 const Figure& figure, const Motion& motion) {
  Result<ImportPlan> plan = PlanImport(source, how);
  if (!plan.ok()) return plan.error();
  return Edits(source, std::move(plan).value(), figure, motion).Find();
}

}  // namespace hazumi
