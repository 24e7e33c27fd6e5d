#include "engine/picture/decode.h"

#include <algorithm>
#include <array>

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

}  // namespace hazumi
