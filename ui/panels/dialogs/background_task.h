#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "engine/base/memory.h"
#include "engine/base/result.h"

namespace hazumi::ui {

// Work beside the interface, in a thread of its own. Its object waits for the end.
template <typename T>
class BackgroundTask {
 public:
  explicit BackgroundTask(std::function<Result<T>()> work)
      : thread_([this, work = std::move(work)] {
          result_ = WithinMemory(work);
          has_ended_ = true;
        }) {}
  ~BackgroundTask() { thread_.join(); }
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;

  // Null before it has ended.
  const Result<T>* result() const { return has_ended_ ? &*result_ : nullptr; }

 private:
  std::optional<Result<T>> result_;  // written before has_ended_ is
  std::atomic<bool> has_ended_ = false;
  std::thread thread_;
};

}  // namespace hazumi::ui
