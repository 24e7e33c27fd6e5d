#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#endif
