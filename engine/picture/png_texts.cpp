// A PNG file: 8 bytes, then chunks: length (4 bytes, big-endian), kind (4 letters), data, checksum
// (4 bytes). tEXt: key, 0, text. iTXt: key, 0, is compressed, method, language, 0, translated
// key, 0, text. [PNG 5.3, 11.3.3]

#include "engine/picture/png_texts.h"

#include <algorithm>
#include <string_view>

namespace hazumi {

namespace {

std::uint32_t Number(std::string_view bytes) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(bytes[i]);
  return number;
}

// CRC-32 of kind and data. [PNG annex D]
std::uint32_t Checksum(std::string_view bytes) {
  std::uint32_t crc = ~0u;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

bool IsText(std::string_view kind) { return kind == "tEXt" || kind == "iTXt"; }

// What stands before the first 0, which goes with it.
std::string_view Cut(std::string_view* data) {
  const size_t end = std::min(data->find('\0'), data->size());
  const std::string_view text = data->substr(0, end);
  data->remove_prefix(std::min(end + 1, data->size()));
  return text;
}

void AddText(std::string_view kind, std::string_view data,
             std::map<std::string, std::string>* texts) {
  const std::string key(Cut(&data));
  if (kind == "iTXt") {
    if (data.size() < 2 || data[0] != 0) return;
    data.remove_prefix(2);
    Cut(&data);
    Cut(&data);
  }
  (*texts)[key] = std::string(data);
}

}  // namespace

std::map<std::string, std::string> PngTexts(std::span<const std::uint8_t> file) {
  std::map<std::string, std::string> texts;
  std::string_view rest(reinterpret_cast<const char*>(file.data()), file.size());
  if (!rest.starts_with("\x89PNG\r\n\x1a\n")) return texts;
  rest.remove_prefix(8);
  while (rest.size() >= 12) {
    const std::uint32_t length = Number(rest);
    if (length > rest.size() - 12) break;
    const std::string_view kind = rest.substr(4, 4);
    if (IsText(kind)) {
      const std::uint32_t checksum = Number(rest.substr(8 + static_cast<size_t>(length)));
      if (checksum != Checksum(rest.substr(4, 4 + static_cast<size_t>(length)))) break;
      AddText(kind, rest.substr(8, length), &texts);
    }
    rest.remove_prefix(12 + static_cast<size_t>(length));
  }
  return texts;
}

}  // namespace hazumi
