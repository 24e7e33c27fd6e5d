#include "engine/picture/decode.h"

#include <algorithm>
#include <array>

#include "engine/picture/picture_bytes.h"

namespace hazumi {

namespace {

constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 3> kJpeg = {0xff, 0xd8, 0xff};

template <size_t kSize>
bool BeginsWith(std::span<const std::uint8_t> file, const std::array<std::uint8_t, kSize>& magic) {
  return file.size() >= kSize && std::equal(magic.begin(), magic.end(), file.begin());
}

}  // namespace

Result<Image> DecodeImage(std::span<const std::uint8_t> file) {
  if (BeginsWith(file, kPng)) return DecodePng(file);
  if (BeginsWith(file, kJpeg)) return DecodeJpeg(file);
  return Error{ErrorCode::kSyntax, "", "",
               "the picture is neither a PNG nor a JPEG; convert it to one of them"};
}

namespace {

// Decodes a picture of at most `pixels_left` pixels, and subtracts its own. Pictures of one file
// share a limit.
Result<Image> DecodeWithin(std::span<const std::uint8_t> file, std::int64_t* pixels_left) {
  Result<Image> image = DecodeImage(file);
  if (!image.ok()) return image;
  const std::int64_t pixels = std::int64_t{image.value().width} * image.value().height;
  if (pixels > *pixels_left) {
    return Error{ErrorCode::kSemantics, "", "",
                 "is left out: only " + std::to_string(*pixels_left) +
                     " pixels are left for it of those that all textures may have together; make "
                     "them smaller"};
  }
  *pixels_left -= pixels;
  return image;
}

}  // namespace

bool DecodeHere(std::string_view request, const std::function<bool(const std::string&)>& pass_on) {
  const Result<PictureRequest> asked = RequestFromBytes(request);
  if (!asked.ok()) return false;
  std::int64_t pixels_left = asked.value().pixels_left;
  for (const std::span<const std::uint8_t> file : asked.value().files) {
    if (!pass_on(AnswerToBytes(DecodeWithin(file, &pixels_left)))) return false;
  }
  return true;
}

}  // namespace hazumi
