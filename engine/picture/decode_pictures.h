#pragma once

// PNG and JPEG files of strangers, decoded in a process of their own.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/child/reader_program.h"
#include "engine/picture/image.h"

namespace hazumi {

// The picture of each file, or why there is none; image.h bounds each and all. One process
// decodes them all; if one ends it, that one is left out and another process goes on with the rest,
// for twice the time of one. Errors: kSyntax where the picture is broken or too large; kFailed
// where the reader is missing or not sound; kInterrupted. `options.limits.answer` has no effect.
std::vector<Result<Image>> DecodePictures(std::span<const std::span<const std::uint8_t>> files,
                                          const ReadOptions& options = {});

}  // namespace hazumi
