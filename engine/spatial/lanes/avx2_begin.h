// Included, not guarded: functions from here on are for processors with AVX2, up to avx2_end.h,
// which ends the file (templates are made there). What is above is compiled without it, so that no
// function of a shared header is.

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif
#define HAZUMI_VECTORS_OF_FOUR
#endif
