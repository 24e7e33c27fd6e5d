#pragma once

#include <cstdint>
#include <span>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi {

// The picture in the bytes of a PNG or JPEG file, told apart by their beginning. The fourth byte of
// a pixel is its alpha. Any bytes may be given; still, what strangers wrote is decoded in
// hazumi-reader only: all others call DecodePictures. Fails with kSyntax: another format, damaged,
// cut off, or too large (picture_limits.h); the message says which.
Result<Image> DecodeImage(std::span<const std::uint8_t> file);

// Of one format. kSyntax as above.
Result<Image> DecodeJpeg(std::span<const std::uint8_t> file);
Result<Image> DecodePng(std::span<const std::uint8_t> file);

}  // namespace hazumi
