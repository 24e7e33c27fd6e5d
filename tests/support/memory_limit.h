#pragma once

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

#include "engine/base/memory.h"

namespace hazumi::test {

inline bool CanLimitMemory() { return !kHasShadowMemory; }

// While it lives, this process gets so many more bytes; what earlier tests freed is given back.
class MemoryLimit {
 public:
  explicit MemoryLimit(double more) {
    ::malloc_trim(0);
    ::getrlimit(RLIMIT_AS, &old_);
    const rlimit limit{Taken() + static_cast<rlim_t>(more), old_.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &old_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  static rlim_t Taken() {
    long pages = 0;
    FILE* file = std::fopen("/proc/self/statm", "r");
    EXPECT_EQ(std::fscanf(file, "%ld", &pages), 1);
    std::fclose(file);
    return static_cast<rlim_t>(pages * ::sysconf(_SC_PAGESIZE));
  }

  rlimit old_{};
};

}  // namespace hazumi::test
