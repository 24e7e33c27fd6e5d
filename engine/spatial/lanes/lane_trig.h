#include "engine/spatial/lanes/lane_algebra.h"

// Sine and cosine of all angles at once.
//
// Cody and Waite: with n = round(2 x / pi), r = x - n pi/2 in three pieces of pi/2, the first two
// of 33 bits, so that n times each is exact for |n| < 2^20; what r loses in rounding is its tail.
// On |r| <= pi/4 the polynomials of FreeBSD's msun. The error is below 1 ulp for |x| <= 1e5;
// beyond, the C library is asked.

constexpr double kLargestAngle = 1e5;  // [rad]

template <int W, typename V = typename LanesOf<W>::Real>
HAZUMI_LANE_INLINE V SineNearZero(V r, V tail, V z) {
  const V low = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04);
  const V high = 2.75573137070700676789e-06 +
                 z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10);
  const V zz = z * z;
  const V cube = z * r;
  return r - ((z * (0.5 * tail - cube * (low + zz * high)) - tail) -
              cube * -1.66666666666666324348e-01);
}

template <int W, typename V = typename LanesOf<W>::Real>
HAZUMI_LANE_INLINE V CosineNearZero(V r, V tail, V z) {
  const V low = 4.16666666666666019037e-02 +
                z * (-1.38888888888741095749e-03 + z * 2.48015872894767294178e-05);
  const V high = -2.75573143513906633035e-07 +
                 z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11);
  const V zz = z * z;
  const V half = 0.5 * z;
  const V rough = 1.0 - half;
  return rough + (((1.0 - rough) - half) + (zz * (low + zz * z * high) - r * tail));
}

template <int W>
HAZUMI_LANE_INLINE void SineAndCosine(typename LanesOf<W>::Real x, typename LanesOf<W>::Real* sine,
                                      typename LanesOf<W>::Real* cosine) {
  using V = typename LanesOf<W>::Real;
  using B = typename LanesOf<W>::Bits;
  // Adding 1.5 * 2^52 leaves the nearest integer in the lowest bits.
  constexpr double kToInteger = 6755399441055744.0;
  const V shifted = x * 6.36619772367581382433e-01 + kToInteger;
  const V n = shifted - kToInteger;
  const V first = x - n * 1.57079632673412561417e+00;
  const V second = n * 6.07710050630396597660e-11;
  const V rough = first - second;
  const V third = n * 2.02226624879595063154e-21 - ((first - rough) - second);
  const V r = rough - third;
  const V tail = (rough - r) - third;
  const V z = r * r;
  const B s = SameBits<B>(SineNearZero<W>(r, tail, z));
  const B c = SameBits<B>(CosineNearZero<W>(r, tail, z));
  const B quadrant = SameBits<B>(shifted);
  const B swapped = -(quadrant & 1);
  const B sine_sign = (quadrant & 2) << 62, cosine_sign = ((quadrant + 1) & 2) << 62;
  *sine = SameBits<V>(((s & ~swapped) | (c & swapped)) ^ sine_sign);
  *cosine = SameBits<V>(((c & ~swapped) | (s & swapped)) ^ cosine_sign);
}

// Not a number counts as large.
template <int W>
HAZUMI_LANE_INLINE typename LanesOf<W>::Bits IsLarge(typename LanesOf<W>::Real x) {
  const typename LanesOf<W>::Real zero = {};
  return ~(Greater(x, zero - kLargestAngle) & Greater(zero + kLargestAngle, x));
}
