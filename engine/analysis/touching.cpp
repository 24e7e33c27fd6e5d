// Contact weights from clearances. A point with the clearance c touches from the instant when c
// falls below a limit l to the instant when c rises above l. The instants are interpolated linearly
// between frames. With d the time from the nearer instant and f the fade time, the weight is
//   weight = u^2 (3 - 2 u),   u = d / f clamped to [0, 1],
// in frames in which the point touches, and 0 in all others. A frame in which the point touches has
// at least the weight kLeast. Loads thus move between points continuously. A point that touches in
// the first or the last frame is assumed to touch long before or after.

#include "engine/analysis/touching.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

TouchedShape PrepareBox(const GrownBox& grown) {
  TouchedShape shape;
  shape.is_plane = false;
  std::copy_n(grown.box.X_WB.R.data(), 9, shape.R_WB);
  std::copy_n(grown.box.X_WB.p.data(), 3, shape.p_WB);
  std::copy_n(grown.box.half_size.data(), 3, shape.half_size);
  shape.margin = grown.margin;
  return shape;
}

TouchedShape Prepare(const Plane& plane) {
  TouchedShape shape;
  std::copy_n(plane.normal.data(), 3, shape.normal);
  shape.offset = plane.offset;
  return shape;
}
TouchedShape Prepare(const Box& box) { return PrepareBox(Grown(box)); }
TouchedShape Prepare(const Capsule& capsule) { return PrepareBox(Grown(capsule)); }

}  // namespace

double FadeIn(double u) {
  const double x = std::clamp(u, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

TouchedShape PrepareShape(const Obstacle& shape) {
  return std::visit([](const auto& of) { return Prepare(of); }, shape);
}

Touching::Touching(const Animation& animation, size_t num_frames, const TouchLimits& limits,
                   const EffortKernels& kernels)
    : animation_(animation),
      limits_(limits),
      kernels_(kernels),
      num_frames_(num_frames),
      num_fours_((num_frames + 3) / 4) {
  for (const SceneObject& object : animation.scene) shapes_.push_back(PrepareShape(object.shape));
  for (const Link& link : animation.figure->links()) {
    if (!IsEndOfParent(link, *animation.figure)) AddEnd(link, link.capsule.a);
    if (link.capsule.a != link.capsule.b) AddEnd(link, link.capsule.b);
  }
  if (shapes_.empty()) return;
  clearance_ = LaneArray::Unset(ends_.size() * num_fours_ * 4);
  touches_ = LaneArray::Unset(ends_.size() * num_fours_ * 4 * TouchField::kNumFields);
}

void Touching::AddEnd(const Link& link, const Vec3& centre) {
  ends_.push_back({link.joint, (link.capsule.b - link.capsule.a).stableNormalized(), centre,
                   link.capsule.radius, static_cast<int>(2 * ends_.size())});
  TouchingBall& ball = balls_.emplace_back();
  ball.body = link.joint.is_valid() ? link.joint.value() + 1 : 0;
  std::copy_n(centre.data(), 3, ball.centre);
  ball.radius = link.capsule.radius;
}

void Touching::AddFour(const double* placed) {
  if (shapes_.empty()) return;
  kernels_.touch(balls_.data(), static_cast<int>(balls_.size()), shapes_.data(),
                 static_cast<int>(shapes_.size()), placed,
                 touches_.data() + num_added_ * ends_.size() * 4 * TouchField::kNumFields,
                 clearance_.data() + 4 * num_added_, static_cast<long>(4 * num_fours_));
  ++num_added_;
}

Vec3 Touching::FieldAt(size_t frame, size_t end, int field) const {
  const double* at =
      touches_.data() +
      4 * (TouchField::kNumFields * (frame / 4 * ends_.size() + end) + static_cast<size_t>(field)) +
      frame % 4;
  return {at[0], at[4], at[8]};
}

void Touching::Finish(double frame_time) {
  weight_.assign(ends_.size() * num_frames_, 0.0f);
  if (shapes_.empty()) return;
  FindLevels(frame_time);
  for (size_t end = 0; end < ends_.size(); ++end) Fade(end, frame_time);
}

void Touching::FindLevels(double frame_time) {
  constexpr double kWindow = 0.3;  // [s]
  level_.assign(num_frames_, 0.0);
  if (limits_.drift == 0.0 || ends_.empty()) return;
  std::vector<double> lowest(num_frames_, 1e300);
  for (size_t end = 0; end < ends_.size(); ++end) {
    const double* clearance = clearance_.data() + end * 4 * num_fours_;
    for (size_t i = 0; i < num_frames_; ++i) lowest[i] = std::min(lowest[i], clearance[i]);
  }
  const auto reach = static_cast<size_t>(std::max(1.0, std::round(kWindow / frame_time)));
  size_t at = num_frames_;  // of the lowest
  for (size_t i = num_frames_; i-- > 0;) {
    const size_t first = i > reach ? i - reach : 0, last = std::min(i + reach, num_frames_ - 1);
    if (at > last) {
      const auto from = lowest.begin() + static_cast<long>(first);
      at = first + static_cast<size_t>(
                       std::min_element(from, lowest.begin() + static_cast<long>(last) + 1) - from);
    } else if (lowest[first] < lowest[at]) {
      at = first;
    }
    if (std::abs(lowest[at]) <= limits_.drift) level_[i] = lowest[at];
  }
}

void Touching::Fade(size_t end, double frame_time) {
  const double* of_end = clearance_.data() + end * 4 * num_fours_;
  const auto clearance = [&](size_t i) { return of_end[i] - level_[i]; };
  const auto touches = [&](size_t i) {
    if (clearance(i) > limits_.clearance) return false;
    const size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, num_frames_ - 1);
    const double way =
        (FieldAt(b, end, TouchField::kCentre) - FieldAt(a, end, TouchField::kCentre)).norm();
    return b == a || way <= limits_.fastest * frame_time * static_cast<double>(b - a);
  };
  // Instants [frames] at which it begins to touch and ends to.
  const auto crossing = [&](size_t i) {  // between i - 1 and i
    const double from = clearance(i - 1) - limits_.clearance, to = clearance(i) - limits_.clearance;
    const double share = from * to < 0.0 ? from / (from - to) : 0.5;
    return static_cast<double>(i) - 1.0 + share;
  };
  constexpr double kLeast = 1e-3;
  const double fade = limits_.fade_frames * animation_.rate.seconds_per_frame() / frame_time;
  for (size_t first = 0; first < num_frames_;) {
    if (!touches(first)) {
      ++first;
      continue;
    }
    size_t last = first;
    while (last + 1 < num_frames_ && touches(last + 1)) ++last;
    const double down = first == 0 ? -1e300 : crossing(first);
    const double up = last + 1 == num_frames_ ? 1e300 : crossing(last + 1);
    for (size_t i = first; i <= last; ++i) {
      const auto at = static_cast<double>(i);
      const double weight = FadeIn(std::min(at - down, up - at) / fade);
      weight_[end * num_frames_ + i] = static_cast<float>(std::max(weight, kLeast));
    }
    first = last + 1;
  }
}

std::vector<Touching::End> Touching::EndsBeyond(JointIndex joint) const {
  std::vector<End> found;
  std::copy_if(ends_.begin(), ends_.end(), std::back_inserter(found), [&](const End& end) {
    return end.joint.is_valid() && animation_.figure->IsBeyond(end.joint, joint);
  });
  return found;
}

void Touching::AddSides(const End& end, const PlacedFrame& placed, const Vec3& normal,
                        double weight, std::vector<ContactPoint>* points) {
  const Vec3 across = end.radius * normal.cross(placed.Turned(end.joint, end.axis));
  const Vec3 point = placed.PointOf(end.joint, end.centre) - end.radius * normal;
  for (const int side : {0, 1}) {
    ContactPoint& of_side = points->emplace_back();
    of_side.joint = end.joint;
    of_side.p = point + (side == 0 ? -across : across);
    of_side.normal = normal;
    of_side.weight = 0.5 * weight;
    of_side.id = end.id + side;
  }
}

void Touching::PointsAt(size_t frame, const PlacedFrame& placed,
                        std::vector<ContactPoint>* points) const {
  for (size_t i = 0; i < ends_.size(); ++i) {
    const float weight = weight_[i * num_frames_ + frame];
    if (weight == 0.0f) continue;
    AddSides(ends_[i], placed, FieldAt(frame, i, TouchField::kNormal), weight, points);
  }
}

}  // namespace hazumi
