#include "engine/media/sound_part.h"

#include <cmath>

#include "engine/base/text.h"

namespace hazumi {

namespace {

std::string Samples(double seconds) { return std::to_string(std::llround(seconds * kSoundRate)); }

}  // namespace

std::string FilterOf(const SoundPart& part) {
  // Counted from the first sample, whatever time the file gives it.
  std::string filter = "aresample=" + std::to_string(kSoundRate) + ",asetpts=N/SR/TB";
  if (part.start_s > 0.0) {
    filter += ",atrim=start_sample=" + Samples(part.start_s) + ",asetpts=PTS-STARTPTS";
  } else if (part.start_s < 0.0) {
    filter += ",adelay=delays=" + Samples(-part.start_s) + "S:all=1";
  }
  if (part.gain_db != 0.0) filter += ",volume=" + FormatNumber(part.gain_db) + "dB";
  const std::string length = Samples(part.length_s);
  return filter + ",apad=whole_len=" + length + ",atrim=end_sample=" + length;
}

}  // namespace hazumi
