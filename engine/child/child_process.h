#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

struct ChildLimits {
  double seconds = 10.0;               // on the clock, from start to end
  size_t output_bytes = 512ull << 20;  // more is taken for garbage
};

// How a child process ended.
struct ChildOutcome {
  enum class End { kExited, kSignalled, kTimedOut, kTooMuchOutput, kCancelled };
  End end = End::kExited;
  int code = 0;        // exit status or signal
  std::string output;  // what it wrote to descriptor kChildOutput
};
constexpr int kChildOutput = 3;

// Runs a program and waits for it. It sees this process's folder and environment, no other
// descriptors than 0, a file that holds `input`, 1 and 2 (/dev/null) and kChildOutput.
// `is_cancelled` may be empty; it is asked every 20 ms. However it ends, the child is gone and
// reaped on return. Safe with other threads. Error (kFailed): it could not be started.
Result<ChildOutcome> RunChild(const std::vector<std::string>& arguments, std::string_view input,
                              const ChildLimits& limits, const std::function<bool()>& is_cancelled);

// Variant of RunChild whose child reads an open file: its descriptor 0 is a copy of `file` and
// continues at the same place.
Result<ChildOutcome> RunChildOn(int file, const std::vector<std::string>& arguments,
                                const ChildLimits& limits,
                                const std::function<bool()>& is_cancelled);

}  // namespace hazumi
