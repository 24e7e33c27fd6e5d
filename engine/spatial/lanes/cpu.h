#pragma once

namespace hazumi {

// Whether this machine runs kernels that were compiled for AVX2. Others give the same bits.
inline bool CpuHasAvx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace hazumi
