#include "render/image/decode.h"

#include <algorithm>
#include <array>

#include "render/image/png.h"

namespace hazumi::render {
namespace {

constexpr std::array<std::uint8_t, 8> kPng = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 3> kJpeg = {0xff, 0xd8, 0xff};

template <size_t kSize>
bool BeginsWith(std::span<const std::uint8_t> file, const std::array<std::uint8_t, kSize>& magic) {
  return file.size() >= kSize && std::equal(magic.begin(), magic.end(), file.begin());
}

}  // namespace

std::string ComplaintOnSize(std::int64_t width, std::int64_t height) {
  const bool fits = width >= 1 && height >= 1 && width <= kMostPixelsASide &&
                    height <= kMostPixelsASide && width * height <= kMostPixels;
  if (fits) return "";
  return "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; at most " + std::to_string(kMostPixelsASide) + " a side and " +
         std::to_string(kMostPixels) + " in all can be read: make it smaller";
}

Result<Image> DecodeImage(std::span<const std::uint8_t> file) {
  if (BeginsWith(file, kPng)) return DecodePng(file);
  if (BeginsWith(file, kJpeg)) return DecodeJpeg(file);
  return Error{ErrorCode::kSyntax, "", "",
               "the picture is neither a PNG nor a JPEG; convert it to one of them"};
}

}  // namespace hazumi::render
