#pragma once

// The words, lines and numbers of a BVH file. A line ends with CR, LF or CR LF.

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// Reads on through a text that outlives it. A copy looks ahead.
class BvhScanner {
 public:
  explicit BvhScanner(std::string_view text) : text_(text) {}

  // The next word, empty at the end of the text. Braces are words of their own.
  std::string_view Word();
  // What is left of this line, up to a brace, without blanks at either end; may be empty.
  std::string_view RestOfLine();
  // The next line that is not blank, without blanks at either end; empty at the end of the text.
  std::string_view Line();

  int line() const { return line_; }  // where the last word or line was; the first is 1
  std::string_view text() const { return text_; }
  size_t bytes_left() const { return text_.size() - at_; }

 private:
  void SkipSpace();  // blanks and line ends
  std::string_view Until(const char* stops);

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
};

// Takes the first word off a line; empty if there is none.
std::string_view TakeWord(std::string_view* line);
std::string_view Trimmed(std::string_view text);
// Whether a word is the keyword (given in lower case), in any case.
bool IsKeyword(std::string_view word, std::string_view keyword);

// The number that a word is, such as "1", "+1", ".5", "5." or "1e-3"; false if it is none or is not
// finite. No locale has a say.
bool ParseBvhNumber(std::string_view word, double* value);
// Says why a word is no number from -limit to limit, and what to do.
std::string WhyNoBvhNumber(std::string_view word, double limit);

// A word of the file for a message: in quotes, short, printable.
std::string QuotedWord(std::string_view word);
std::string LinePlace(int line);
Error BvhError(int line, std::string message, ErrorCode code = ErrorCode::kSyntax);

}  // namespace hazumi
