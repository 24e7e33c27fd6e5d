#pragma once

// Values of options from their texts. Each reads the whole text, or returns nothing.

#include <optional>
#include <string_view>

#include "app/cli/options.h"

namespace hazumi {

std::optional<int> ReadInt(std::string_view text);
std::optional<double> ReadFinite(std::string_view text);
// "7", or "5..15" with the first not after the last.
std::optional<FrameRange> ReadRange(std::string_view text);
// "640x360", each from 16 to 16384.
std::optional<PictureSize> ReadSize(std::string_view text);
// "30", "29.97" (to three decimals) or "30000/1001": 0.1 to 10000 frames a second.
std::optional<FrameRate> ReadRate(std::string_view text);
// Whether a file's name is that of a video: .mp4 in any case.
bool IsVideo(std::string_view path);
// "skin", "capsules" or "both".
std::optional<render::FigureLook> ReadBody(std::string_view text);
// The name of a side, or six or seven numbers.
std::optional<CameraChoice> ReadCamera(std::string_view text);

}  // namespace hazumi
