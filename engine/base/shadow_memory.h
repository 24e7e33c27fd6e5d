#pragma once

namespace hazumi {

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
