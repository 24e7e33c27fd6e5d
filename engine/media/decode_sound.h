#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/base/result.h"
#include "engine/media/sound_part.h"

namespace hazumi {

struct SoundFormat {
  int rate = 48000;  // samples a second
  int channels = 2;
};

struct Sound {
  SoundFormat format;
  std::vector<std::int16_t> samples;  // those of all channels, one instant after the other
};

// All of a file's first sound, decoded by ffmpeg. Errors, with the file's name: kNoInput if it
// cannot be opened, kSyntax if ffmpeg finds no sound in it, kFailed without ffmpeg or if it is too
// long, kInterrupted if `is_cancelled`, which may be empty.
Result<Sound> DecodeSound(const std::filesystem::path& file, const SoundFormat& format,
                          const std::function<bool()>& is_cancelled);

// Decodes a part of a sound file to stereo with kSoundRate samples a second. Errors: as
// DecodeSound.
Result<Sound> DecodeSoundPart(const SoundPart& part, const std::function<bool()>& is_cancelled);

}  // namespace hazumi
