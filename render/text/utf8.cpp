#include "render/text/utf8.h"

namespace hazumi::render {
namespace {

// Bytes in the sequence a lead byte opens; 0 if it opens none.
int SequenceLength(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

bool AreContinuations(std::string_view bytes) {
  for (const unsigned char b : bytes) {
    if ((b & 0xc0) != 0x80) return false;
  }
  return true;
}

}  // namespace

std::u32string DecodeUtf8(std::string_view text) {
  std::u32string codes;
  while (!text.empty()) {
    const auto lead = static_cast<unsigned char>(text[0]);
    size_t length = SequenceLength(lead);
    if (length == 0 || length > text.size() || !AreContinuations(text.substr(1, length - 1))) {
      codes.push_back(U'\ufffd');
      text.remove_prefix(1);
      continue;
    }
    char32_t code = length == 1 ? lead : lead & (0x7f >> length);
    for (size_t i = 1; i < length; ++i) code = (code << 6) | (text[i] & 0x3f);
    codes.push_back(code);
    text.remove_prefix(length);
  }
  return codes;
}

}  // namespace hazumi::render
