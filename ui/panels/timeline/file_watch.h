#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "ui/panels/dialogs/background_task.h"

namespace hazumi::ui {

// Reads a file beside the interface; again when it is another one, has changed, or is to be read
// otherwise.
template <typename T>
class FileWatch {
 public:
  using IsCancelled = std::function<bool()>;
  using Read = std::function<Result<T>(const std::string& path, const IsCancelled& is_cancelled)>;

  FileWatch() = default;
  ~FileWatch() { Stop(); }
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // `how`: with it what is read changes. An empty path: nothing is to be read.
  void Look(const std::string& path, const std::string& how, const Read& read) {
    Version now{path, how, {}};
    std::error_code missing;
    const auto changed = std::filesystem::last_write_time(path, missing);
    if (!missing) now.changed = changed;
    if (now == seen_) return;
    seen_ = now;
    Stop();
    if (path.empty()) return;
    task_ = std::make_unique<BackgroundTask<T>>(
        [this, path, read] { return read(path, [this] { return cancel_.load(); }); });
  }

  bool is_busy() const { return task_ && !task_->result(); }
  // Null while it is not known.
  const T* value() const {
    const Result<T>* result = task_ ? task_->result() : nullptr;
    return result && result->ok() ? &result->value() : nullptr;
  }
  // Why there is none; empty: there is one, or it is being read.
  std::string error() const {
    const Result<T>* result = task_ ? task_->result() : nullptr;
    return result && !result->ok() ? result->error().ToString() : "";
  }

 private:
  // A file as it is between two changes.
  struct Version {
    std::string path, how;
    std::filesystem::file_time_type changed;
    bool operator==(const Version&) const = default;
  };
  void Stop() {
    cancel_ = true;
    task_.reset();
    cancel_ = false;
  }

  Version seen_;
  std::atomic<bool> cancel_ = false;
  std::unique_ptr<BackgroundTask<T>> task_;
};

}  // namespace hazumi::ui
