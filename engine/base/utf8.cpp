#include "engine/base/utf8.h"

namespace hazumi {

namespace {

bool IsContinuation(unsigned char c) { return (c & 0xC0) == 0x80; }

// Bytes in a sequence that begins with `lead`; 0: nothing begins so.
size_t LengthAfter(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if ((lead & 0xF0) == 0xE0) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

// The second byte is restricted after some leads: overlong, surrogate, too high.
bool IsSecondAllowed(unsigned char lead, unsigned char second) {
  if (lead == 0xE0) return second >= 0xA0;
  if (lead == 0xED) return second < 0xA0;
  if (lead == 0xF0) return second >= 0x90;
  if (lead == 0xF4) return second < 0x90;
  return true;
}

// Length of the well-formed sequence at the start of `text`, 0 if it is malformed.
size_t SequenceLength(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const size_t length = LengthAfter(lead);
  if (length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i) {
    if (!IsContinuation(static_cast<unsigned char>(text[i]))) return 0;
  }
  if (length > 1 && !IsSecondAllowed(lead, static_cast<unsigned char>(text[1]))) return 0;
  return length;
}

// `sequence` is one well-formed sequence.
char32_t CodePoint(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return lead;
  char32_t code = lead & (0x7Fu >> sequence.size());
  for (const char c : sequence.substr(1)) {
    code = (code << 6) | (static_cast<unsigned char>(c) & 0x3Fu);
  }
  return code;
}

}  // namespace

size_t FindInvalidUtf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    const size_t length = SequenceLength(text.substr(i));
    if (length == 0) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::string ValidUtf8(std::string_view text) {
  std::string valid;
  for (size_t bad; (bad = FindInvalidUtf8(text)) != std::string_view::npos;) {
    valid.append(text.substr(0, bad)).append("\xEF\xBF\xBD");
    text.remove_prefix(bad + 1);
  }
  return valid.append(text);
}

std::u32string DecodeUtf8(std::string_view text) {
  std::u32string codes;
  while (!text.empty()) {
    const size_t length = SequenceLength(text);
    codes.push_back(length == 0 ? U'\uFFFD' : CodePoint(text.substr(0, length)));
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return codes;
}

}  // namespace hazumi
