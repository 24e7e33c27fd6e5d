#pragma once

// Pictures between hazumi and hazumi-reader, as bytes: the files to decode, and what became of
// each. Versioned, of one machine's byte order; not a file format.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi {

struct PictureRequest {
  std::int64_t pixels_left = 0;  // how many they may have together
  std::vector<std::span<const std::uint8_t>> files;
};

std::string RequestToBytes(std::span<const std::span<const std::uint8_t>> files,
                           std::int64_t pixels_left);
// Its files lie in `bytes`. Error (kSyntax): it is no whole request.
Result<PictureRequest> RequestFromBytes(std::string_view bytes);

// What became of one file; answers follow one another.
std::string AnswerToBytes(Result<Image> decoded);

// The answers that are whole and sound, in their order, from the beginning up to the first that is
// not. Any bytes may come in. No picture is larger than image.h allows, all together have
// no more than `pixels_left`, and there are `most` answers at most. Takes no more memory than
// `bytes` does.
std::vector<Result<Image>> AnswersFromBytes(std::string_view bytes, size_t most,
                                            std::int64_t pixels_left);

}  // namespace hazumi
