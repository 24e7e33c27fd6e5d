#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/picture/image.h"

namespace hazumi::render {

// Reads a PNG file back, of our own making, in this process.
Result<Image> ReadPng(const std::filesystem::path& path);

}  // namespace hazumi::render
