#pragma once

#include <cstdint>
#include <span>

#include "engine/base/result.h"
#include "render/image/image.h"

namespace hazumi::render {

// The largest picture that is decoded. What comes from a stranger's file must not take all memory.
constexpr int kMostPixelsASide = 16384;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;  // 256 MB decoded

// The picture in the bytes of a PNG or JPEG file, told apart by their beginning. The fourth byte of
// a pixel is its alpha. Any bytes may be given. Fails with kSyntax: another format, damaged, cut
// off, or too large; the message says which.
Result<Image> DecodeImage(std::span<const std::uint8_t> file);

// Of one format. kSyntax as above.
Result<Image> DecodeJpeg(std::span<const std::uint8_t> file);

// "... at most so many pixels" if a picture of this size is empty or too large; else "".
std::string ComplaintOnSize(std::int64_t width, std::int64_t height);

}  // namespace hazumi::render
