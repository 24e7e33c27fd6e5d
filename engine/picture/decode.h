#pragma once

// Decoders, for hazumi-reader and tests only: what strangers wrote may end the process.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi {

// The picture in the bytes of a PNG or JPEG file, told apart by their beginning. The fourth byte of
// a pixel is its alpha. Any bytes may be given; still, what strangers wrote is decoded in
// hazumi-reader only: all others call DecodePictures. Fails with kSyntax: another format, damaged,
// cut off, or too large (image.h); the message says which.
Result<Image> DecodeImage(std::span<const std::uint8_t> file);

// Of one format. kSyntax as above.
Result<Image> DecodeJpeg(std::span<const std::uint8_t> file);
Result<Image> DecodePng(std::span<const std::uint8_t> file);

// Decodes the pictures of a request (picture_bytes.h) in this process, which a broken one may end:
// for hazumi-reader only, all others call DecodePictures. Passes on each answer as soon as it is
// there. False: it is no request, or an answer could not be passed on.
bool DecodeHere(std::string_view request, const std::function<bool(const std::string&)>& pass_on);

}  // namespace hazumi
