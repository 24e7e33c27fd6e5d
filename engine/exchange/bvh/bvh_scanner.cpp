#include "engine/exchange/bvh/bvh_scanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/base/text.h"
#include "engine/base/utf8.h"

namespace hazumi {

namespace {

constexpr const char* kBlanks = " \t\v\f";
constexpr const char* kWordEnds = " \t\v\f\r\n{}";

}  // namespace

void BvhScanner::SkipSpace() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    const bool second_half = c == '\n' && at_ > 0 && text_[at_ - 1] == '\r';
    if ((c == '\n' || c == '\r') && !second_half) ++line_;
    if (c != '\n' && c != '\r' && c != ' ' && c != '\t' && c != '\v' && c != '\f') return;
  }
}

std::string_view BvhScanner::Until(const char* stops) {
  const size_t begin = at_;
  at_ = std::min(text_.find_first_of(stops, at_), text_.size());
  return text_.substr(begin, at_ - begin);
}

std::string_view BvhScanner::Word() {
  SkipSpace();
  if (at_ >= text_.size()) return {};
  if (text_[at_] == '{' || text_[at_] == '}') return text_.substr(at_++, 1);
  return Until(kWordEnds);
}

std::string_view BvhScanner::RestOfLine() { return Trimmed(Until("\r\n{}")); }

std::string_view BvhScanner::Line() {
  SkipSpace();
  return Trimmed(Until("\r\n"));
}

std::string_view Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string_view TakeWord(std::string_view* line) {
  const size_t begin = line->find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    line->remove_prefix(line->size());
    return {};
  }
  const size_t end = std::min(line->find_first_of(kBlanks, begin), line->size());
  const std::string_view word = line->substr(begin, end - begin);
  line->remove_prefix(end);
  return word;
}

bool IsKeyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

bool ParseBvhNumber(std::string_view word, double* value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, *value);
  if (stop != end) return false;
  if (code == std::errc::result_out_of_range) {
    // Too small for a double is nought; too large is no number.
    *value = 0.0;
    return word.find("e-") != word.npos || word.find("E-") != word.npos;
  }
  return code == std::errc() && std::isfinite(*value);
}

std::string WhyNoBvhNumber(std::string_view word, double limit) {
  const std::string start = word.empty() ? "a number is missing" : QuotedWord(word);
  double value = 0.0;
  if (ParseBvhNumber(word, &value)) {
    return start + " is out of range (largest: " + FormatNumber(limit) +
           "); the file is damaged here, correct the value or export it again";
  }
  if (word.find(',') != word.npos) {
    return start +
           " has a comma; numbers need a decimal point and blanks between them, so replace " +
           "the commas or export with an English locale";
  }
  if (word.empty()) return start + "; add it or export the file again";
  return start + " is not a finite number; correct it or export the file again";
}

std::string QuotedWord(std::string_view word) {
  size_t shown = std::min<size_t>(word.size(), 32);
  const auto inside_letter = [&] {
    return (static_cast<unsigned char>(word[shown]) & 0xc0) == 0x80;
  };
  while (shown > 0 && shown < word.size() && inside_letter()) --shown;
  std::string text = ValidUtf8(word.substr(0, shown));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return "\"" + text + (word.size() > shown ? "...\"" : "\"");
}

std::string LinePlace(int line) { return "line " + std::to_string(line); }

Error BvhError(int line, std::string message, ErrorCode code) {
  return {code, "", LinePlace(line), std::move(message)};
}

}  // namespace hazumi
