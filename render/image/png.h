#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi::render {

// A text chunk. `key`: 1-79 printable Latin-1 characters. A value that is not plain ASCII is stored
// as an international chunk (iTXt, UTF-8).
struct PngText {
  std::string key;
  std::string value;  // UTF-8
};

// The bytes of an 8-bit RGB PNG with an sRGB chunk, the texts in order, and no date: equal input
// gives equal bytes. Fails (kCannotWrite) on a picture without pixels or a bad key.
Result<std::vector<std::uint8_t>> EncodePng(const Image& image, const std::vector<PngText>& texts);

// Encodes and writes atomically (engine/base/atomic_file.h).
Result<Done> WritePng(const std::filesystem::path& path, const Image& image,
                      const std::vector<PngText>& texts);

}  // namespace hazumi::render
