#pragma once

#include <atomic>

namespace hazumi::fuzz {

// Flag that is set once the thread that made it has used the given processor time [s], whatever the
// load of the machine. Only one may exist at a time.
class Deadline {
 public:
  explicit Deadline(double seconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  const std::atomic<bool>* flag() const;
};

}  // namespace hazumi::fuzz
