#include "tests/fuzz/deadline.h"

#include <pthread.h>
#include <time.h>

#include <chrono>
#include <cstdint>
#include <thread>

namespace hazumi::fuzz {

namespace {

std::atomic<bool> is_over = false;
std::atomic<clockid_t> clock_of_worker = CLOCK_MONOTONIC;
std::atomic<int64_t> end_ns = INT64_MAX;

int64_t NowNs(clockid_t clock) {
  timespec now = {};
  ::clock_gettime(clock, &now);
  return int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

// One thread for all inputs: starting one for each would take longer than most of them.
void Watch() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (NowNs(clock_of_worker) > end_ns) is_over = true;
  }
}

}  // namespace

Deadline::Deadline(double seconds) {
  static const bool is_watched = (std::thread(Watch).detach(), true);
  static_cast<void>(is_watched);
  clockid_t clock = CLOCK_MONOTONIC;
  ::pthread_getcpuclockid(::pthread_self(), &clock);
  clock_of_worker = clock;
  is_over = false;
  end_ns = NowNs(clock) + static_cast<int64_t>(1e9 * seconds);
}

Deadline::~Deadline() { end_ns = INT64_MAX; }

const std::atomic<bool>* Deadline::flag() const { return &is_over; }

}  // namespace hazumi::fuzz
