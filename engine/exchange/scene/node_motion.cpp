#include "engine/exchange/scene/node_motion.h"

#include <algorithm>
#include <cmath>

namespace hazumi {
namespace {

using Value = Eigen::Vector4d;

Eigen::Quaterniond ToRotation(const Value& v) {
  const Eigen::Quaterniond q(v[3], v[0], v[1], v[2]);
  return q.norm() > 1e-9 ? q.normalized() : Eigen::Quaterniond::Identity();
}

Value Hermite(const JointKeys& keys, size_t i, double s) {
  const double d = keys.times[i + 1] - keys.times[i];
  const double s2 = s * s, s3 = s2 * s;
  return (2.0 * s3 - 3.0 * s2 + 1.0) * keys.values[i] + d * (s3 - 2.0 * s2 + s) * keys.behind[i] +
         (3.0 * s2 - 2.0 * s3) * keys.values[i + 1] + d * (s3 - s2) * keys.before[i + 1];
}

// The key before a time, and the part of the segment behind it that has passed.
struct Place {
  size_t key;
  double part;
};

Place Find(const JointKeys& keys, double t, double slack) {
  const bool is_stepped = keys.interpolation == KeyInterpolation::kStep;
  if (is_stepped) t += slack;
  const auto after = std::upper_bound(keys.times.begin(), keys.times.end(), t);
  if (after == keys.times.begin()) return {0, 0.0};
  const auto key = static_cast<size_t>(after - keys.times.begin() - 1);
  if (after == keys.times.end() || is_stepped) return {key, 0.0};
  return {key, (t - keys.times[key]) / (keys.times[key + 1] - keys.times[key])};
}

std::optional<Vec3> Vector(const JointKeys& keys, double t, double slack) {
  if (keys.empty()) return std::nullopt;
  const auto [i, s] = Find(keys, t, slack);
  Value value = keys.values[i];
  if (s > 0.0) {
    value = keys.interpolation == KeyInterpolation::kSpline
                ? Hermite(keys, i, s)
                : Value(value + s * (keys.values[i + 1] - value));
  }
  return value.head<3>();
}

std::optional<Eigen::Quaterniond> Rotation(const JointKeys& keys, double t, double slack) {
  if (keys.empty()) return std::nullopt;
  const auto [i, s] = Find(keys, t, slack);
  if (s > 0.0 && keys.interpolation == KeyInterpolation::kSpline)
    return ToRotation(Hermite(keys, i, s));
  const Eigen::Quaterniond value = ToRotation(keys.values[i]);
  return s > 0.0 ? value.slerp(s, ToRotation(keys.values[i + 1])).normalized() : value;
}

bool AreSound(const JointKeys& keys) {
  constexpr double kLatest = 1e9;  // [s]
  const auto is_finite = [](const Value& value) { return value.allFinite(); };
  const auto is_time = [](double time) { return std::abs(time) < kLatest; };
  return std::all_of(keys.times.begin(), keys.times.end(), is_time) &&
         std::is_sorted(keys.times.begin(), keys.times.end()) &&
         std::all_of(keys.values.begin(), keys.values.end(), is_finite) &&
         std::all_of(keys.before.begin(), keys.before.end(), is_finite) &&
         std::all_of(keys.behind.begin(), keys.behind.end(), is_finite);
}

}  // namespace

NodeValue KeyedMotion::At(double t, double slack) const {
  NodeValue value;
  value.translation = Vector(translation, t, slack);
  value.rotation = Rotation(rotation, t, slack);
  value.scale = Vector(scale, t, slack);
  return value;
}

void KeyedMotion::AddTimes(std::vector<double>* times) const {
  for (const JointKeys* keys : {&translation, &rotation, &scale}) {
    if (keys->times.size() > 1) times->insert(times->end(), keys->times.begin(), keys->times.end());
  }
}

bool KeyedMotion::IsSound() const {
  return AreSound(translation) && AreSound(rotation) && AreSound(scale);
}

}  // namespace hazumi
