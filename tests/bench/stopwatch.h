#pragma once

#include <time.h>

#include <algorithm>
#include <limits>

namespace hazumi::bench {

// Keeps a value alive that is computed only to be timed.
template <typename T>
inline void KeepAlive(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

// Processor time of this process [s], which others that run meanwhile have little part in. The
// programs that are compared use one thread each.
inline double ProcessorSeconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The least time of a call over all rounds.
class LeastTime {
 public:
  // Times `call(i)`, i = 0, 1, ..., repeated for at least `batch_seconds`.
  template <typename Call>
  void Round(double batch_seconds, const Call& call) {
    const auto run = [&](long count) {
      const double start = ProcessorSeconds();
      for (long i = 0; i < count; ++i) call(i);
      return ProcessorSeconds() - start;
    };
    double seconds = run(calls_);
    for (; seconds < batch_seconds; seconds = run(calls_)) {
      const double wanted = 1.2 * batch_seconds / std::max(seconds, 1e-9);
      calls_ = static_cast<long>(std::min(10.0, std::max(wanted, 1.1)) * calls_ + 1.0);
    }
    least_us_ = std::min(least_us_, 1e6 * seconds / static_cast<double>(calls_));
  }
  double microseconds() const { return least_us_; }

 private:
  long calls_ = 1;
  double least_us_ = std::numeric_limits<double>::infinity();
};

}  // namespace hazumi::bench
