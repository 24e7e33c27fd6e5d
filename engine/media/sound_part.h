#pragma once

#include <filesystem>
#include <string>

namespace hazumi {

// A part of a sound file, as it is heard with a part of a motion: exactly as long, with silence
// before the file's beginning and behind its end.
struct SoundPart {
  std::filesystem::path file;
  double start_s = 0.0;   // where in the file the part begins; negative: silence first
  double length_s = 0.0;  // of the part
  double gain_db = 0.0;
  bool operator==(const SoundPart&) const = default;
};

inline constexpr int kSoundRate = 48000;  // samples a second

// An audio filter of ffmpeg that makes the part of its file, to the sample.
std::string FilterOf(const SoundPart& part);

}  // namespace hazumi
