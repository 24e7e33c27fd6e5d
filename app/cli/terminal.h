#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace hazumi {

// The text with control characters and malformed UTF-8 written out as \x1b, so that a name in a
// file cannot steer the terminal.
std::string Printable(std::string_view text);

// The text without its middle if it is too long for anybody to read: names may be.
std::string Shortened(std::string text);

// Prints one line, made as by printf and then Printable and Shortened.
[[gnu::format(printf, 2, 3)]] void PrintLine(std::FILE* stream, const char* format, ...);

// Makes sure that there are standard streams, so that no file that is opened later becomes one.
void KeepStandardStreams();
// To be called last: whatever was printed to standard output is there, or a complaint is printed.
// Returns the program's exit code: `exit_code` unless that is kExitOk and something is missing.
int FinishOutput(int exit_code);

// Prints "hazumi: MESSAGE" and where to find help to standard error. Returns kExitUsage.
int ComplainOfUsage(const std::string& message);

// Progress on standard error: a bar on a terminal, else a line a step.
class Progress {
 public:
  Progress(std::string what, int total);
  void Report(int done, const std::string& detail);
  void Finish();

 private:
  std::string what_;
  int total_;
  bool on_terminal_;
};

}  // namespace hazumi
