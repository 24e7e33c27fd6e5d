#pragma once

// Lack of memory as an error, and whether address space can be limited.

#include <new>

#include "engine/base/result.h"

namespace hazumi {

inline Error OutOfMemory() {
  return {ErrorCode::kFailed, "", "", "there is not enough memory for it"};
}

// What work() returns, or an Error where the memory does not suffice: for threads, which would
// otherwise end the program, and for whoever can go on without.
template <typename Work>
auto WithinMemory(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return OutOfMemory();
  }
}

// True in builds with the address or thread sanitizer. Their shadow memory takes terabytes of
// addresses, so address space cannot be limited. g++ defines macros, clang has features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kHasShadowMemory = true;
#elif defined(__has_feature)
inline constexpr bool kHasShadowMemory =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kHasShadowMemory = false;
#endif

}  // namespace hazumi
