#include "engine/exchange/assimp/channel_sample.h"

#include <algorithm>
#include <cmath>

namespace hazumi {
namespace {

Vec3 ValueOf(const aiVectorKey& key) { return {key.mValue.x, key.mValue.y, key.mValue.z}; }
Eigen::Quaterniond ValueOf(const aiQuatKey& key) {
  const Eigen::Quaterniond q(key.mValue.w, key.mValue.x, key.mValue.y, key.mValue.z);
  return q.norm() > 1e-9 ? q.normalized() : Eigen::Quaterniond::Identity();
}

Vec3 Between(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }
Eigen::Quaterniond Between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double t) {
  return a.slerp(t, b).normalized();
}

template <typename Key>
auto Sample(const Key* keys, unsigned count, bool is_stepped, double slack, double tick)
    -> std::optional<decltype(ValueOf(*keys))> {
  if (count == 0) return std::nullopt;
  if (is_stepped) tick += slack;
  const Key* after = std::upper_bound(keys, keys + count, tick,
                                      [](double t, const Key& key) { return t < key.mTime; });
  if (after == keys) return ValueOf(keys[0]);
  const Key& before = *(after - 1);
  if (after == keys + count || is_stepped) return ValueOf(before);
  return Between(ValueOf(before), ValueOf(*after),
                 (tick - before.mTime) / (after->mTime - before.mTime));
}

bool IsFinite(const aiVectorKey& key) {
  return std::isfinite(key.mValue.x) && std::isfinite(key.mValue.y) && std::isfinite(key.mValue.z);
}
bool IsFinite(const aiQuatKey& key) {
  return std::isfinite(key.mValue.w) && std::isfinite(key.mValue.x) &&
         std::isfinite(key.mValue.y) && std::isfinite(key.mValue.z);
}

template <typename Key>
bool AreSound(const Key* keys, unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    if (!IsFinite(keys[i]) || !(std::abs(keys[i].mTime) < 1e12) ||
        (i > 0 && keys[i].mTime < keys[i - 1].mTime))
      return false;
  }
  return true;
}

}  // namespace

ChannelValue SampleChannel(const aiNodeAnim& channel, const ChannelSteps& steps, double tick) {
  ChannelValue value;
  value.translation =
      Sample(channel.mPositionKeys, channel.mNumPositionKeys, steps.translation, steps.slack, tick);
  value.rotation =
      Sample(channel.mRotationKeys, channel.mNumRotationKeys, steps.rotation, steps.slack, tick);
  value.scale =
      Sample(channel.mScalingKeys, channel.mNumScalingKeys, steps.scale, steps.slack, tick);
  return value;
}

bool IsSoundChannel(const aiNodeAnim& channel) {
  return AreSound(channel.mPositionKeys, channel.mNumPositionKeys) &&
         AreSound(channel.mRotationKeys, channel.mNumRotationKeys) &&
         AreSound(channel.mScalingKeys, channel.mNumScalingKeys);
}

}  // namespace hazumi
