#pragma once

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

}  // namespace hazumi
