#include "engine/picture/decode_here.h"

#include "engine/picture/decode.h"
#include "engine/picture/picture_bytes.h"

namespace hazumi {
namespace {

// Of all that are allowed together, as many are left as `pixels_left` says.
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
