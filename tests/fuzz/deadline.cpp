#include "tests/fuzz/deadline.h"

#include <chrono>
#include <cstdint>
#include <thread>

namespace hazumi::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> is_over = false;
std::atomic<int64_t> end_ns = INT64_MAX;

int64_t NowNs() { return std::chrono::nanoseconds(Clock::now().time_since_epoch()).count(); }

// One thread for all inputs: starting one for each would take longer than most of them.
void Watch() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (NowNs() > end_ns) is_over = true;
  }
}

}  // namespace

Deadline::Deadline(double seconds) {
  static const bool is_watched = (std::thread(Watch).detach(), true);
  static_cast<void>(is_watched);
  is_over = false;
  end_ns = NowNs() + static_cast<int64_t>(1e9 * seconds);
}

Deadline::~Deadline() { end_ns = INT64_MAX; }

const std::atomic<bool>* Deadline::flag() const { return &is_over; }

}  // namespace hazumi::fuzz
