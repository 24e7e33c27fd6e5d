#include "tests/support/allocation_count.h"

#include <atomic>
#include <cerrno>
#include <cstddef>

// operator new and Eigen both end in malloc, so taking its place sees them all. Sanitizers bring a
// malloc of their own.
#if defined(__has_feature)  // clang's way to tell
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HAZUMI_COUNTS_ALLOCATIONS 1
#else
#define HAZUMI_COUNTS_ALLOCATIONS 0
#endif

namespace {
std::atomic<long> allocation_count{0};
}

#if HAZUMI_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(size_t);            // NOLINT: glibc's names
void* __libc_calloc(size_t, size_t);    // NOLINT
void* __libc_realloc(void*, size_t);    // NOLINT
void* __libc_memalign(size_t, size_t);  // NOLINT

void* malloc(size_t size) {
  ++allocation_count;
  return __libc_malloc(size);
}
void* calloc(size_t number, size_t size) {
  ++allocation_count;
  return __libc_calloc(number, size);
}
void* realloc(void* block, size_t size) {
  ++allocation_count;
  return __libc_realloc(block, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  ++allocation_count;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, size_t alignment, size_t size) {
  ++allocation_count;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
}
#endif

namespace hazumi::test {

bool CanCountAllocations() { return HAZUMI_COUNTS_ALLOCATIONS; }
long AllocationCount() { return allocation_count; }

}  // namespace hazumi::test
