#pragma once

#include <cmath>

namespace hazumi {

inline constexpr double kSameFrame = 1e-9;  // instants this near are one [frames]

// Frames per second as a fraction, e.g. 30/1 or 30000/1001.
struct FrameRate {
  int num = 30;
  int den = 1;

  double frames_per_second() const { return static_cast<double>(num) / den; }
  double seconds_per_frame() const { return static_cast<double>(den) / num; }
  // Time of a frame (which need not be whole) since frame 0 [s].
  double SecondsAt(double frame) const { return frame * den / num; }
  double FrameAt(double seconds) const { return seconds * num / den; }
  bool operator==(const FrameRate&) const = default;
};

// The time of a frame at one rate, in frames at another one. Within kSameFrame of a whole frame it
// is that frame: seconds are rounded, so that FrameAt(SecondsAt(123)) need not be 123.
inline double FrameAtRate(double frame, const FrameRate& rate, const FrameRate& other) {
  const double there = other.FrameAt(rate.SecondsAt(frame)), whole = std::round(there);
  return std::abs(there - whole) < kSameFrame ? whole : there;
}

// Whether a half-open span of frames has an instant. The animation's last frame, `end`, belongs to
// the span that ends there.
inline bool HasInstant(int first, int last, double frame, int end) {
  return frame >= first && (frame < last || (last == end && frame == last));
}

}  // namespace hazumi
