#include "engine/bake/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

// More do not find enough islands to solve.
constexpr int kMostThreads = 8;

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
constexpr microseconds kAwake(50), kExpecting(200);

// Where other programs want the processor as well one yield may take milliseconds: time is
// counted, not yields.
template <typename Condition>
void YieldUntil(Condition&& condition, microseconds most) {
  const Clock::time_point end = Clock::now() + most;
  while (!condition() && Clock::now() < end) std::this_thread::yield();
}

}  // namespace

ThreadPool::ThreadPool(int most) {
  const int has = static_cast<int>(std::thread::hardware_concurrency());
  most_ = static_cast<size_t>(std::clamp(most > 0 ? most : has, 1, kMostThreads) - 1);
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::Do(int count, const std::function<void(int)>& job) {
  HAZUMI_ASSERT(count >= 0 && job);
  next_ = 0;
  thrown_ = nullptr;
  if (count <= 1 || most_ == 0) {
    Work(job, count);
    return Rethrow();
  }
  const size_t wanted = std::min(most_, static_cast<size_t>(count) - 1);
  {
    const std::lock_guard lock(mutex_);
    job_ = &job;
    count_ = count;
  }
  AddHelpers(wanted);
  wake_.notify_all();
  Work(job, count);
  // The last jobs are nearly done: to sleep and be woken would take longer.
  YieldUntil([this] { return working_ == 0; }, kAwake);
  std::unique_lock lock(mutex_);
  job_ = nullptr;
  rest_.wait(lock, [this] { return working_ == 0; });
  Rethrow();
}

void ThreadPool::Rethrow() {
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

// The system may refuse threads; then fewer do the work.
void ThreadPool::AddHelpers(size_t wanted) {
  try {
    while (helpers_.size() < wanted) helpers_.emplace_back([this] { Help(); });
  } catch (const std::system_error&) {
  }
}

void ThreadPool::Expect() {
  if (helpers_.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    is_expecting_ = true;
  }
  wake_.notify_all();
}

void ThreadPool::StayAwake(microseconds most) const {
  YieldUntil([this] { return job_ != nullptr || is_over_; }, most);
}

void ThreadPool::Work(const std::function<void(int)>& job, int count) {
  for (int i = next_++; i < count; i = next_++) Try(job, i);
}

void ThreadPool::Try(const std::function<void(int)>& job, int i) {
  try {
    job(i);
  } catch (...) {  // for want of memory, say
    const std::lock_guard lock(mutex_);
    if (!thrown_) thrown_ = std::current_exception();
  }
}

void ThreadPool::Help() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return is_over_ || is_expecting_ || job_ != nullptr; });
    if (is_over_) return;
    if (is_expecting_) {
      is_expecting_ = false;
      lock.unlock();
      StayAwake(kExpecting);
      lock.lock();
    }
    if (job_ == nullptr) continue;
    const std::function<void(int)>& job = *job_;
    const int count = count_;
    ++working_;
    lock.unlock();
    Work(job, count);
    lock.lock();
    job_ = nullptr;  // all jobs are taken
    if (--working_ == 0) rest_.notify_one();
    lock.unlock();
    StayAwake(kAwake);
    lock.lock();
  }
}

}  // namespace hazumi
