// Zero-moment point: a frame requires the force F and the moment M about the centre of mass, which
// is at a height h above the ground. They are equivalent to a force through one point of the ground
// and a moment about z. Relative to the projection of the centre of mass, that point is
//   (x, y) = ((-M_y - h F_x) / F_z, (M_x - h F_y) / F_z).
// Soles can supply F and M if the point lies within the convex hull of the contact points.

#include "engine/analysis/missing_support.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi {

namespace {

using Vec2 = Eigen::Vector2d;

double Cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct HullPoint {
  Vec2 p;
  JointIndex joint;
};

// Returns the hull counterclockwise. Builds the lower and the upper half as monotone chains.
std::vector<HullPoint> ConvexHull(std::vector<HullPoint> points) {
  std::sort(points.begin(), points.end(), [](const HullPoint& a, const HullPoint& b) {
    return a.p.x() != b.p.x() ? a.p.x() < b.p.x() : a.p.y() < b.p.y();
  });
  std::vector<HullPoint> hull;
  const auto add = [&](const HullPoint& point, size_t start) {
    while (hull.size() >= start + 2 &&
           Cross(hull.back().p - hull[hull.size() - 2].p, point.p - hull.back().p) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const HullPoint& point : points) add(point, 0);
  const size_t lower = hull.size() - 1;
  for (size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

struct Beyond {
  double distance = 0.0;  // 0 within the hull [m]
  JointIndex joint;       // joint of the nearest corner
};

Beyond BeyondHull(const Vec2& p, const std::vector<HullPoint>& hull) {
  Beyond beyond;
  beyond.distance = std::numeric_limits<double>::max();
  double corner = beyond.distance;
  bool is_within = hull.size() > 2;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i].p, way = hull[(i + 1) % hull.size()].p - a;
    const double along = way.squaredNorm() > 0.0 ? (p - a).dot(way) / way.squaredNorm() : 0.0;
    is_within = is_within && Cross(way, p - a) >= 0.0;
    beyond.distance = std::min(beyond.distance, (p - a - std::clamp(along, 0.0, 1.0) * way).norm());
    if ((p - a).norm() >= corner) continue;
    corner = (p - a).norm();
    beyond.joint = hull[i].joint;
  }
  if (is_within) beyond.distance = 0.0;
  return beyond;
}

// Moves the wrench to the centre of mass, at `from_root` from the root's origin.
Wrench AboutCom(const Wrench& on_root, const Vec3& from_root) {
  return {on_root.force, on_root.moment - from_root.cross(on_root.force)};
}

class MissingFinder {
 public:
  explicit MissingFinder(const Animation& animation)
      : figure_(*animation.figure),
        weight_(figure_.total_mass() * std::max(std::abs(animation.gravity), 1.0)),
        size_(SizeOf(figure_)) {}

  // Residual wrench in units of kMissing. Values up to 1 are not reported.
  double Severity(const MissingSupport& missing) const {
    const double moment = size_ > 0.0 ? missing.moment / (size_ * weight_) : 0.0;
    return std::max(missing.force / weight_, moment) / kMissing;
  }

  MissingSupport In(const MotionFrame& frame, const FrameEffort& effort) const {
    MissingSupport missing;
    missing.first = missing.last = missing.worst = frame.frame;
    const Wrench lacking = AboutCom(effort.from_nowhere, frame.com - frame.X_WR.p);
    missing.force = lacking.force.norm();
    missing.moment = lacking.moment.norm();
    if (Severity(missing) <= 1.0) return missing;
    if (effort.contacts.empty()) {
      const bool floats = missing.force > kMissing * weight_;
      missing.fault = floats ? SupportFault::kFloats : SupportFault::kTurnsInAir;
      return missing;
    }
    Wrench needed = lacking;
    for (const EffortContact& contact : effort.contacts) {
      needed.force += contact.force;
      needed.moment += (contact.p - frame.com).cross(contact.force);
    }
    Classify(needed, frame.com, effort, &missing);
    return missing;
  }

 private:
  static double SizeOf(const Figure& figure) {
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, Pose(), figure.RestAngles(), &ws);
    double size = 0.0;
    for (int j = 0; j < figure.num_joints(); ++j) {
      size = std::max(size, ws.body(JointIndex(j)).p.norm());
    }
    return size;
  }

  void Classify(const Wrench& needed, const Vec3& com, const FrameEffort& effort,
                MissingSupport* missing) const {
    constexpr double kAlike = 0.2;  // share of the distance
    if (missing->force > kMissing * weight_) {
      const bool is_down = needed.force.z() < 0.0;
      missing->fault = is_down ? SupportFault::kPulled : SupportFault::kSlides;
      return;
    }
    missing->fault = SupportFault::kTurned;
    const bool grips = std::any_of(effort.contacts.begin(), effort.contacts.end(),
                                   [](const EffortContact& contact) { return contact.is_grip; });
    if (grips || needed.force.z() <= kMissing * weight_) return;
    std::vector<HullPoint> points;
    double height = com.z();
    for (const EffortContact& contact : effort.contacts) {
      points.push_back({contact.p.head<2>(), contact.joint});
      height -= contact.p.z() / static_cast<double>(effort.contacts.size());
    }
    const std::vector<HullPoint> hull = ConvexHull(std::move(points));
    const Vec2 below = com.head<2>();
    const Vec2 zmp = below + Vec2(-needed.moment.y() - height * needed.force.x(),
                                  needed.moment.x() - height * needed.force.y()) /
                                 needed.force.z();
    const Beyond beyond = BeyondHull(zmp, hull), of_mass = BeyondHull(below, hull);
    if (beyond.distance < 0.5 * kMissing * size_) return;
    const bool is_mass = std::abs(beyond.distance - of_mass.distance) < kAlike * beyond.distance;
    missing->fault = is_mass ? SupportFault::kTips : SupportFault::kPushedOff;
    missing->distance = is_mass ? of_mass.distance : beyond.distance;
    missing->joint = beyond.joint;
  }

  const Figure& figure_;
  double weight_, size_;  // [N, m]
};

}  // namespace

std::vector<MissingSupport> MissingSupports(const Animation& animation, const Motion& motion,
                                            const Effort& effort) {
  constexpr int kPause = 2;  // [frames]
  const MissingFinder finder(animation);
  std::vector<MissingSupport> found;
  for (size_t i = 0; i < effort.frames.size(); ++i) {
    MissingSupport missing = finder.In(motion.frames[i], effort.frames[i]);
    if (finder.Severity(missing) <= 1.0) continue;
    if (found.empty() || missing.first - found.back().last > kPause) {
      found.push_back(missing);
      continue;
    }
    missing.first = found.back().first;
    found.back().last = missing.last;
    if (finder.Severity(missing) > finder.Severity(found.back())) found.back() = missing;
  }
  return found;
}

}  // namespace hazumi
