// One or four numbers, one a lane, with the arithmetic of one.
//
// The text of lane_numbers, lane_algebra and lane_trig, each with those before it, is compiled once
// for every instruction set: a file of kernels includes what it needs inside a namespace of its
// own. So there is no #pragma once, and nothing here includes headers of the library. Without fused
// multiply-add, a lane gives the same bits everywhere.

#define HAZUMI_LANE_INLINE inline __attribute__((always_inline))

#if !defined(HAZUMI_VECTORS_OF_FOUR)
// Four numbers as two vectors of two: a vector of four would be taken apart into single numbers.
template <typename Half, typename Number>
struct LanePair {
  Half lo, hi;

  friend HAZUMI_LANE_INLINE LanePair operator+(LanePair a, LanePair b) {
    return {a.lo + b.lo, a.hi + b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator-(LanePair a, LanePair b) {
    return {a.lo - b.lo, a.hi - b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator*(LanePair a, LanePair b) {
    return {a.lo * b.lo, a.hi * b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator/(LanePair a, LanePair b) {
    return {a.lo / b.lo, a.hi / b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator&(LanePair a, LanePair b) {
    return {a.lo & b.lo, a.hi & b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator|(LanePair a, LanePair b) {
    return {a.lo | b.lo, a.hi | b.hi};
  }
  friend HAZUMI_LANE_INLINE LanePair operator^(LanePair a, LanePair b) {
    return {a.lo ^ b.lo, a.hi ^ b.hi};
  }
  HAZUMI_LANE_INLINE LanePair operator-() const { return {-lo, -hi}; }
  HAZUMI_LANE_INLINE LanePair operator~() const { return {~lo, ~hi}; }
  HAZUMI_LANE_INLINE LanePair operator<<(int bits) const { return {lo << bits, hi << bits}; }

  static HAZUMI_LANE_INLINE LanePair All(Number x) { return {Half{x, x}, Half{x, x}}; }
  friend HAZUMI_LANE_INLINE LanePair operator+(LanePair a, Number b) { return a + All(b); }
  friend HAZUMI_LANE_INLINE LanePair operator-(LanePair a, Number b) { return a - All(b); }
  friend HAZUMI_LANE_INLINE LanePair operator*(LanePair a, Number b) { return a * All(b); }
  friend HAZUMI_LANE_INLINE LanePair operator&(LanePair a, Number b) { return a & All(b); }
  friend HAZUMI_LANE_INLINE LanePair operator+(Number a, LanePair b) { return All(a) + b; }
  friend HAZUMI_LANE_INLINE LanePair operator-(Number a, LanePair b) { return All(a) - b; }
  friend HAZUMI_LANE_INLINE LanePair operator*(Number a, LanePair b) { return All(a) * b; }

  HAZUMI_LANE_INLINE LanePair& operator+=(LanePair b) { return *this = *this + b; }
  HAZUMI_LANE_INLINE LanePair& operator-=(LanePair b) { return *this = *this - b; }
  HAZUMI_LANE_INLINE LanePair& operator|=(LanePair b) { return *this = *this | b; }
};
#endif

template <int W>
struct LanesOf;
template <>
struct LanesOf<1> {
  using Real = double;
  using Bits = int64_t;
};
template <>
struct LanesOf<4> {
#if defined(HAZUMI_VECTORS_OF_FOUR)
  typedef double Real __attribute__((vector_size(32)));
  typedef int64_t Bits __attribute__((vector_size(32)));
#else
  typedef double HalfReal __attribute__((vector_size(16)));
  typedef int64_t HalfBits __attribute__((vector_size(16)));
  using Real = LanePair<HalfReal, double>;
  using Bits = LanePair<HalfBits, int64_t>;
#endif
};

// From and to memory aligned to the size of the lanes.
template <int W>
HAZUMI_LANE_INLINE typename LanesOf<W>::Real Load(const double* at) {
  typename LanesOf<W>::Real value;
  __builtin_memcpy(&value, __builtin_assume_aligned(at, 8 * W), 8 * W);
  return value;
}
template <int W>
HAZUMI_LANE_INLINE void Store(double* at, typename LanesOf<W>::Real value) {
  __builtin_memcpy(__builtin_assume_aligned(at, 8 * W), &value, 8 * W);
}

HAZUMI_LANE_INLINE LanesOf<4>::Real FromFour(double a, double b, double c, double d) {
#if defined(HAZUMI_VECTORS_OF_FOUR)
  return LanesOf<4>::Real{a, b, c, d};
#else
  return {LanesOf<4>::HalfReal{a, b}, LanesOf<4>::HalfReal{c, d}};
#endif
}

// From anywhere: at[from[0]], at[from[1]], ...
HAZUMI_LANE_INLINE LanesOf<4>::Real Collect(const double* at, const int* from) {
  return FromFour(at[from[0]], at[from[1]], at[from[2]], at[from[3]]);
}

HAZUMI_LANE_INLINE LanesOf<4>::Real SquareRoot(LanesOf<4>::Real x) {
#if defined(__clang__) || !defined(__x86_64__)
  double of[4];
  __builtin_memcpy(of, &x, sizeof of);
  return FromFour(__builtin_sqrt(of[0]), __builtin_sqrt(of[1]), __builtin_sqrt(of[2]),
                  __builtin_sqrt(of[3]));
#elif defined(HAZUMI_VECTORS_OF_FOUR)
  return __builtin_ia32_sqrtpd256(x);
#else
  return {__builtin_ia32_sqrtpd(x.lo), __builtin_ia32_sqrtpd(x.hi)};
#endif
}

// All bits of a lane set where a > b.
HAZUMI_LANE_INLINE int64_t Greater(double a, double b) { return -static_cast<int64_t>(a > b); }
HAZUMI_LANE_INLINE LanesOf<4>::Bits Greater(LanesOf<4>::Real a, LanesOf<4>::Real b) {
#if defined(HAZUMI_VECTORS_OF_FOUR)
  return a > b;
#else
  return {a.lo > b.lo, a.hi > b.hi};
#endif
}

HAZUMI_LANE_INLINE bool AnySet(LanesOf<4>::Bits bits) {
  int64_t lane[4];
  __builtin_memcpy(lane, &bits, sizeof lane);
  return (lane[0] | lane[1] | lane[2] | lane[3]) != 0;
}

// The sum over all lanes of each.
HAZUMI_LANE_INLINE LanesOf<4>::Real SumsOf(LanesOf<4>::Real a, LanesOf<4>::Real b,
                                           LanesOf<4>::Real c, LanesOf<4>::Real d) {
#if defined(HAZUMI_VECTORS_OF_FOUR)
  const LanesOf<4>::Real ab =
      __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const LanesOf<4>::Real cd =
      __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
#else
  const auto pairs = [](LanesOf<4>::HalfReal x, LanesOf<4>::HalfReal y) {
    return __builtin_shufflevector(x, y, 0, 2) + __builtin_shufflevector(x, y, 1, 3);
  };
  return {pairs(a.lo, b.lo) + pairs(a.hi, b.hi), pairs(c.lo, d.lo) + pairs(c.hi, d.hi)};
#endif
}

// To be called before kernels return: with the upper halves of registers in use, instructions for
// vectors of two, all over the program, would have to preserve them.
HAZUMI_LANE_INLINE void LeaveLanes() {
#if defined(HAZUMI_VECTORS_OF_FOUR)
  __builtin_ia32_vzeroupper();
#endif
}

template <typename To, typename From>
HAZUMI_LANE_INLINE To SameBits(From from) {
  return __builtin_bit_cast(To, from);
}
