// Frame g of the new clip has the time t = g / rate. In frames of the old clip, of s seconds each,
// that is x = t / s. The value is interpolated between frames floor(x) and floor(x) + 1, with the
// weight x - floor(x) of the latter.

#include "engine/exchange/character/resampled.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

constexpr double kSlack = 0.02;  // of a frame: an end this much later counts as on the frame

Vec3 Mixed(const Vec3& a, const Vec3& b, double share) { return a + share * (b - a); }
Eigen::Quaterniond Mixed(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share) {
  return a.slerp(share, b);
}

template <typename Value>
void Resample(double old_frames_a_new_one, int count, std::vector<Value>* values) {
  if (values->empty()) return;
  std::vector<Value> mixed;
  mixed.reserve(static_cast<size_t>(count));
  const size_t last = values->size() - 1;
  for (int frame = 0; frame < count; ++frame) {
    const double at = std::min(frame * old_frames_a_new_one, static_cast<double>(last));
    const auto before = static_cast<size_t>(at);
    const double share = at - static_cast<double>(before);
    const Value& from = (*values)[before];
    mixed.push_back(share > 0.0 ? Mixed(from, (*values)[before + 1], share) : from);
  }
  *values = std::move(mixed);
}

}  // namespace

void Resample(double rate, Clip* clip) {
  const double old_frames_a_new_one = 1.0 / (rate * clip->seconds_per_frame);
  if (clip->num_frames < 1 || std::abs(old_frames_a_new_one - 1.0) < 1e-9) return;
  const double last = (clip->num_frames - 1) / old_frames_a_new_one;
  clip->num_frames = static_cast<int>(std::ceil(last - kSlack)) + 1;
  clip->seconds_per_frame = 1.0 / rate;
  for (BoneTrack& track : clip->tracks) {
    Resample(old_frames_a_new_one, clip->num_frames, &track.rotations);
    Resample(old_frames_a_new_one, clip->num_frames, &track.translations);
    Resample(old_frames_a_new_one, clip->num_frames, &track.scales);
    track.angles.clear();
  }
}

}  // namespace hazumi
