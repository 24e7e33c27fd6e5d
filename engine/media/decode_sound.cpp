#include "engine/media/decode_sound.h"

#include <cstring>
#include <string>
#include <vector>

#include "engine/media/ffmpeg.h"

namespace hazumi {

namespace {

// Decodes a file through an audio filter of ffmpeg; empty: no filter.
Result<Sound> Decode(const std::filesystem::path& file, const SoundFormat& format,
                     const std::string& filter, const std::function<bool()>& is_cancelled) {
  std::vector<std::string> output = {"-map", "0:a:0", "-f", "s16le"};
  output.insert(output.end(), {"-ac", std::to_string(format.channels)});
  output.insert(output.end(), {"-ar", std::to_string(format.rate)});
  if (!filter.empty()) output.insert(output.end(), {"-af", filter});
  const Result<std::string> bytes =
      RunFfmpeg(file, output, {"sound", "choose another file, or convert it to WAV"}, is_cancelled);
  if (!bytes.ok()) return bytes.error();
  Sound sound{format, {}};
  sound.samples.resize(bytes.value().size() / sizeof(std::int16_t));
  std::memcpy(sound.samples.data(), bytes.value().data(),
              sound.samples.size() * sizeof(std::int16_t));
  return sound;
}

}  // namespace

Result<Sound> DecodeSound(const std::filesystem::path& file, const SoundFormat& format,
                          const std::function<bool()>& is_cancelled) {
  return Decode(file, format, "", is_cancelled);
}

Result<Sound> DecodeSoundPart(const SoundPart& part, const std::function<bool()>& is_cancelled) {
  return Decode(part.file, {kSoundRate, 2}, FilterOf(part), is_cancelled);
}

}  // namespace hazumi
