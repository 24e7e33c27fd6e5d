#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace hazumi::bench {

// Keeps a value alive that is computed only to be timed.
template <typename T>
inline void KeepAlive(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

// The least time of a call over all rounds.
class LeastTime {
 public:
  // Times `call(i)`, i = 0, 1, ..., repeated for at least `batch_seconds`.
  template <typename Call>
  void Round(double batch_seconds, const Call& call) {
    using Clock = std::chrono::steady_clock;
    const auto run = [&](long count) {
      const Clock::time_point start = Clock::now();
      for (long i = 0; i < count; ++i) call(i);
      return std::chrono::duration<double>(Clock::now() - start).count();
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
