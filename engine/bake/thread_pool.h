#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace hazumi {

// Does independent jobs on several threads, that of the caller among them. The others start when
// they are first needed and wait for more until the pool is gone. One thread may call at a time.
class ThreadPool {
 public:
  // At most so many threads, the caller's included; 0: as many as the machine has.
  explicit ThreadPool(int most = 0);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // Calls job(0) to job(count - 1), each once, in any order and thread; returns when all are done.
  // One job alone is done in the caller's thread. What a job throws ends here, after all others.
  void Do(int count, const std::function<void(int)>& job);
  // Jobs are soon to come: the others wake up, and stay awake for a fifth of a millisecond.
  void Expect();

 private:
  void AddHelpers(size_t wanted);
  void Help();
  void StayAwake(std::chrono::microseconds most) const;
  void Work(const std::function<void(int)>& job, int count);
  void Rethrow();
  void Try(const std::function<void(int)>& job, int i);

  size_t most_;  // threads besides the caller's
  std::vector<std::thread> helpers_;
  std::atomic<int> next_ = 0;  // job to be taken
  std::mutex mutex_;           // of what follows
  std::condition_variable wake_, rest_;
  std::atomic<const std::function<void(int)>*> job_ = nullptr;  // null: nothing to take
  int count_ = 0;
  std::exception_ptr thrown_;     // the first
  std::atomic<int> working_ = 0;  // helpers; written under the mutex
  bool is_expecting_ = false;
  std::atomic<bool> is_over_ = false;  // written under the mutex
};

}  // namespace hazumi
