#pragma once

#include <string>

namespace hazumi {

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
