// S_b are the axes of bone b, S_p those of its parent. The body stands when all S_b are I.
//   hips, spine, neck, head, clavicle   S_b = I: at rest they are upright
//   upper arm, forearm, thigh, shin     S_b = T S_p, T the least turn that takes the parent's -z
//                                       to d, the direction to the next bone of the limb
//   hand, finger                        the same, d to the middle of its fingers, or to its end
//   foot                                S_b = Rz(a), a the direction of its toes: it is flat
//   toe, others                         S_b = S_p
// A forearm or shin that is bent by more than 8 degrees at rest tells how the limb above it is
// turned about itself: its hinge is along d_p x d_b, unless that is over 60 degrees from where it
// would be otherwise. Facing: with L the sum of the ways from right to left, the forward direction
// is L x z.

#include "engine/body/body_axes.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kLeastBend = 8.0 * kDegree, kMostTurn = 60.0 * kDegree;
constexpr double kTogether = 1e-9;         // [m]
constexpr double kAside = 70.0 * kDegree;  // of a foot, from forward

bool IsOfLimb(BodyRole role) {
  return (role >= BodyRole::kUpperArm && role <= BodyRole::kFinger) || role == BodyRole::kThigh ||
         role == BodyRole::kShin;
}

bool IsUpright(BodyRole role) { return role >= BodyRole::kHips && role <= BodyRole::kClavicle; }

BodyRole Next(BodyRole role) {
  switch (role) {
    case BodyRole::kUpperArm:
      return BodyRole::kForearm;
    case BodyRole::kForearm:
      return BodyRole::kHand;
    case BodyRole::kHand:
      return BodyRole::kFinger;
    case BodyRole::kThigh:
      return BodyRole::kShin;
    case BodyRole::kShin:
      return BodyRole::kFoot;
    case BodyRole::kFoot:
      return BodyRole::kToe;
    default:
      return role;
  }
}

class Axes {
 public:
  explicit Axes(const std::vector<RestBone>& bones) : bones_(bones) {}

  std::vector<Mat3> Find() {
    for (size_t b = 0; b < bones_.size(); ++b) axes_.push_back(AxesOf(b));
    return std::move(axes_);
  }

 private:
  const RestBone& bone(size_t b) const { return bones_[b]; }

  bool IsBelow(size_t b, size_t top) const {
    int at = static_cast<int>(b);
    while (at > static_cast<int>(top)) at = bones_[static_cast<size_t>(at)].parent;
    return at == static_cast<int>(top);
  }

  // To the next bone of the limb, the middle of those if there are several; else to its end.
  std::optional<Vec3> DirectionOf(size_t b) const {
    const BodyPlace next = {Next(bone(b).place.role), bone(b).place.side};
    Vec3 sum = Vec3::Zero();
    int num = 0;
    for (size_t other = b + 1; other < bones_.size(); ++other) {
      if (bone(other).place != next || !IsBelow(other, b)) continue;
      if (next.role == BodyRole::kFinger && bone(other).parent != static_cast<int>(b)) continue;
      sum += bone(other).X_R.p - bone(b).X_R.p;
      ++num;
    }
    if (num == 0 && bone(b).end) {
      sum = *bone(b).end - bone(b).X_R.p;
      num = 1;
    }
    if (num == 0 || sum.norm() < kTogether) return std::nullopt;
    return sum.normalized();
  }

  // The nearest bone above it with a part in the limb; -1: none.
  int NextLimb(size_t b) const {
    const BodyPlace next = {Next(bone(b).place.role), bone(b).place.side};
    for (size_t other = b + 1; other < bones_.size(); ++other) {
      if (bone(other).place == next && IsBelow(other, b)) return static_cast<int>(other);
    }
    return -1;
  }

  Mat3 Above(size_t b) const {
    return bone(b).parent < 0 ? Mat3(Mat3::Identity()) : axes_[static_cast<size_t>(bone(b).parent)];
  }

  Mat3 AxesOf(size_t b) const {
    const BodyRole role = bone(b).place.role;
    if (IsUpright(role)) return Mat3::Identity();
    if (role == BodyRole::kFoot) return FootAxes(b);
    Mat3 above = Above(b);
    if (!IsOfLimb(role)) return above;
    const std::optional<Vec3> d = DirectionOf(b);
    if (!d) return above;
    const Mat3 S = Eigen::Quaterniond::FromTwoVectors(-above.col(2), *d).toRotationMatrix() * above;
    const bool has_hinge = role == BodyRole::kUpperArm || role == BodyRole::kThigh;
    return has_hinge ? TurnedToBend(b, *d, S) : S;
  }

  // Turned about itself so that the joint below it bends about y.
  Mat3 TurnedToBend(size_t b, const Vec3& d, const Mat3& S) const {
    const int below = NextLimb(b);
    if (below < 0) return S;
    const std::optional<Vec3> after = DirectionOf(static_cast<size_t>(below));
    if (!after) return S;
    const Vec3 bend = d.cross(*after);
    if (bend.norm() < std::sin(kLeastBend)) return S;
    // An elbow bends forward, about -y; a knee backward, about y.
    const Vec3 y = (bone(b).place.role == BodyRole::kThigh ? 1.0 : -1.0) * bend.normalized();
    if (y.dot(S.col(1)) < std::cos(kMostTurn)) return S;
    Mat3 turned;
    turned.col(2) = -d;
    turned.col(1) = y;
    turned.col(0) = y.cross(Vec3(-d));
    return turned;
  }

  Mat3 FootAxes(size_t b) const {
    std::optional<Vec3> d = DirectionOf(b);
    if (!d || d->head<2>().norm() < kTogether) return Mat3::Identity();
    const double aside = std::atan2(d->y(), d->x());
    if (std::abs(aside) > kAside) return Mat3::Identity();
    return Eigen::AngleAxisd(aside, Vec3::UnitZ()).toRotationMatrix();
  }

  const std::vector<RestBone>& bones_;
  std::vector<Mat3> axes_;
};

}  // namespace

std::vector<Mat3> BodyAxesOf(const std::vector<RestBone>& bones) { return Axes(bones).Find(); }

std::optional<double> FacingOf(const std::vector<RestBone>& bones) {
  Vec3 left = Vec3::Zero();
  int num_left = 0, num_right = 0;
  for (const RestBone& bone : bones) {
    const bool is_limb = IsOfLimb(bone.place.role) || bone.place.role == BodyRole::kFoot;
    if (!is_limb || bone.place.side == BodySide::kMiddle) continue;
    const bool is_left = bone.place.side == BodySide::kLeft;
    left += is_left ? bone.X_R.p : Vec3(-bone.X_R.p);
    ++(is_left ? num_left : num_right);
  }
  if (num_left == 0 || num_left != num_right) return std::nullopt;
  const Vec3 forward = left.cross(Vec3::UnitZ());
  if (forward.norm() < kTogether) return std::nullopt;
  return std::atan2(forward.y(), forward.x());
}

}  // namespace hazumi
