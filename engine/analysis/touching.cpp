// A point's clearance c is known in each frame. It touches from where c falls below a limit l to
// where it rises above it, at instants found on straight lines between two frames. With d the time
// from the nearest of these instants, positive while it touches, and f the time in which it fades,
//   weight = u^2 (3 - 2 u),   u = d / f + 1/2 within 0 and 1:
// half at the touch-down itself, all of it f / 2 later, and continuous, so that nothing that
// weights share out jumps. What touches in the first or the last frame has done so, or will, for
// long.

#include "engine/analysis/touching.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/collision/distance.h"
#include "engine/placement/contact.h"

namespace hazumi {

namespace {

// A toe begins at the ball, where the foot ends: one point, which the foot has.
bool IsEndOfParent(const Link& link, const Figure& figure) {
  constexpr double kSame = 1e-3;  // [m]
  if (!link.joint.is_valid() || link.capsule.a.norm() > kSame) return false;
  const Joint& first = figure.joint(figure.group(figure.joint(link.joint).group).first);
  const std::vector<Link>& links = figure.links();
  return std::any_of(links.begin(), links.end(), [&](const Link& other) {
    if (other.joint != first.parent || other.capsule.radius < link.capsule.radius) return false;
    return (other.capsule.a - first.X_PJ.p).norm() <= kSame ||
           (other.capsule.b - first.X_PJ.p).norm() <= kSame;
  });
}

}  // namespace

Touching::Touching(const Animation& animation, size_t num_frames, const TouchLimits& limits)
    : animation_(animation), limits_(limits) {
  if (animation.scene.empty()) return;
  const std::vector<Link>& links = animation.figure->links();
  for (size_t i = 0; i < links.size(); ++i) {
    if (!IsEndOfParent(links[i], *animation.figure)) ends_.push_back({static_cast<int>(i), false});
    if (links[i].capsule.a != links[i].capsule.b) ends_.push_back({static_cast<int>(i), true});
  }
  clearance_.reserve(ends_.size() * num_frames);
  if (limits_.fastest < 1e300) centre_.reserve(ends_.size() * num_frames);
}

Capsule Touching::BallOf(const End& end, const PlacedFrame& placed) const {
  const Link& link = animation_.figure->links()[static_cast<size_t>(end.link)];
  const Vec3 p = placed.PointOf(link.joint, end.is_b ? link.capsule.b : link.capsule.a);
  return {p, p, link.capsule.radius};
}

Distance Touching::NearestTo(const Capsule& ball) const {
  Distance nearest;
  nearest.value = 1e300;
  for (const SceneObject& object : animation_.scene) {
    const Distance distance = SignedDistance(ball, object.shape);
    if (distance.value < nearest.value) nearest = distance;
  }
  return nearest;
}

void Touching::Add(const PlacedFrame& placed) {
  ++num_frames_;
  for (const End& end : ends_) {
    const Capsule ball = BallOf(end, placed);
    clearance_.push_back(static_cast<float>(NearestTo(ball).value));
    if (limits_.fastest < 1e300) centre_.push_back(ball.a);
  }
}

void Touching::Finish(double frame_time) {
  weight_.assign(clearance_.size(), 0.0f);
  FindLevels(frame_time);
  for (size_t end = 0; end < ends_.size(); ++end) Fade(end, frame_time);
}

void Touching::FindLevels(double frame_time) {
  constexpr double kWindow = 0.3;  // [s]
  level_.assign(num_frames_, 0.0);
  if (limits_.drift == 0.0 || ends_.empty()) return;
  std::vector<double> lowest(num_frames_);
  for (size_t i = 0; i < num_frames_; ++i) {
    const auto first = clearance_.begin() + static_cast<long>(i * ends_.size());
    lowest[i] = *std::min_element(first, first + static_cast<long>(ends_.size()));
  }
  const auto reach = static_cast<size_t>(std::max(1.0, std::round(kWindow / frame_time)));
  for (size_t i = 0; i < num_frames_; ++i) {
    const auto from = static_cast<long>(i > reach ? i - reach : 0);
    const auto to = static_cast<long>(std::min(i + reach + 1, num_frames_));
    const double level = *std::min_element(lowest.begin() + from, lowest.begin() + to);
    if (std::abs(level) <= limits_.drift) level_[i] = level;
  }
}

void Touching::Fade(size_t end, double frame_time) {
  const size_t stride = ends_.size();
  const auto clearance = [&](size_t i) { return clearance_[i * stride + end] - level_[i]; };
  const auto touches = [&](size_t i) {
    if (clearance(i) > limits_.clearance) return false;
    if (centre_.empty()) return true;
    const size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, num_frames_ - 1);
    const double way = (centre_[b * stride + end] - centre_[a * stride + end]).norm();
    return b == a || way <= limits_.fastest * frame_time * static_cast<double>(b - a);
  };
  // Instants [frames] at which it begins to touch and ends to.
  const auto crossing = [&](size_t i) {  // between i - 1 and i
    const double from = clearance(i - 1) - limits_.clearance, to = clearance(i) - limits_.clearance;
    const double share = from * to < 0.0 ? from / (from - to) : 0.5;
    return static_cast<double>(i) - 1.0 + share;
  };
  const double fade = limits_.fade_frames * animation_.rate.seconds_per_frame() / frame_time;
  const auto reach = static_cast<long>(std::ceil(0.5 * fade)) + 1;
  for (size_t first = 0; first < num_frames_;) {
    if (!touches(first)) {
      ++first;
      continue;
    }
    size_t last = first;
    while (last + 1 < num_frames_ && touches(last + 1)) ++last;
    const double down = first == 0 ? -1e300 : crossing(first);
    const double up = last + 1 == num_frames_ ? 1e300 : crossing(last + 1);
    const long from = std::max(0L, static_cast<long>(first) - reach);
    const long to = std::min(static_cast<long>(num_frames_) - 1, static_cast<long>(last) + reach);
    for (long i = from; i <= to; ++i) {
      const auto at = static_cast<double>(i);
      const double u = std::clamp(std::min(at - down, up - at) / fade + 0.5, 0.0, 1.0);
      float& weight = weight_[static_cast<size_t>(i) * stride + end];
      weight = std::max(weight, static_cast<float>(u * u * (3.0 - 2.0 * u)));
    }
    first = last + 1;
  }
}

void Touching::PointsAt(size_t frame, const PlacedFrame& placed,
                        std::vector<ContactPoint>* points) const {
  constexpr float kLeast = 1e-6f;
  for (size_t i = 0; i < ends_.size(); ++i) {
    const float weight = weight_[frame * ends_.size() + i];
    if (weight < kLeast) continue;
    const Capsule ball = BallOf(ends_[i], placed);
    const Distance near = NearestTo(ball);
    const Link& link = animation_.figure->links()[static_cast<size_t>(ends_[i].link)];
    const Vec3 axis = placed.Turned(link.joint, link.capsule.b - link.capsule.a).stableNormalized();
    const Vec3 side = ball.radius * near.normal.cross(axis);
    for (const double sign : {-1.0, 1.0}) {
      points->push_back(
          {link.joint, near.point_on_capsule + sign * side, near.normal, 0.5 * weight});
    }
  }
}

}  // namespace hazumi
