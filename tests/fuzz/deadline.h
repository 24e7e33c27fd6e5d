#pragma once

#include <atomic>

namespace hazumi::fuzz {

// A flag that says "enough" once the thread that made it has worked for some processor time [s],
// whatever else the machine does; one at a time.
class Deadline {
 public:
  explicit Deadline(double seconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  const std::atomic<bool>* flag() const;
};

}  // namespace hazumi::fuzz
