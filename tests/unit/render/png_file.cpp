#include "png_file.h"

#include "engine/picture/decode.h"
#include "temp_folder.h"

namespace hazumi::render {

Result<Image> ReadPng(const std::filesystem::path& path) {
  const std::string bytes = BytesOf(path);
  return DecodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace hazumi::render
