#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace hazumi {

// The text chunks of a PNG file that are not compressed, by their keys: tEXt (Latin-1) and iTXt
// (UTF-8). Of what is no PNG, or damaged, those before the damage.
std::map<std::string, std::string> PngTexts(std::span<const std::uint8_t> file);

}  // namespace hazumi
