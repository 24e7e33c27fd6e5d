#include "engine/media/decode_sound.h"

#include <cstring>
#include <string>
#include <vector>

#include "engine/media/ffmpeg.h"

namespace hazumi {

Result<Sound> DecodeSound(const std::filesystem::path& file, const SoundFormat& format,
                          const std::function<bool()>& is_cancelled) {
  const std::vector<std::string> output = {"-map", "0:a:0",
                                           "-f",   "s16le",
                                           "-ac",  std::to_string(format.channels),
                                           "-ar",  std::to_string(format.rate)};
  const Result<std::string> bytes =
      RunFfmpeg(file, output, {"sound", "choose another file, or convert it to WAV"}, is_cancelled);
  if (!bytes.ok()) return bytes.error();
  Sound sound{format, {}};
  sound.samples.resize(bytes.value().size() / sizeof(std::int16_t));
  std::memcpy(sound.samples.data(), bytes.value().data(),
              sound.samples.size() * sizeof(std::int16_t));
  return sound;
}

}  // namespace hazumi
