#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "render/image/image.h"

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

// The picture in the bytes of any PNG as 8-bit RGBA, at most as large as decode.h allows; `texts`
// (optional) receives its text chunks. Fails with kSyntax.
Result<Image> DecodePng(std::span<const std::uint8_t> file, std::vector<PngText>* texts = nullptr);

// Reads back any PNG as 8-bit RGBA; `texts` (optional) receives its text chunks.
// Fails with kNoInput (cannot be read) or kSyntax (not a PNG).
Result<Image> ReadPng(const std::filesystem::path& path, std::vector<PngText>* texts = nullptr);

}  // namespace hazumi::render
