#include "engine/spatial/lanes/lane_numbers.h"

// Vectors and matrices whose every entry is one number a lane.

template <typename V>
struct Triple {
  V e[3];
};

template <typename V>
HAZUMI_LANE_INLINE Triple<V> operator+(const Triple<V>& a, const Triple<V>& b) {
  return {{a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]}};
}
template <typename V>
HAZUMI_LANE_INLINE Triple<V> Scaled(V s, const Triple<V>& a) {
  return {{s * a.e[0], s * a.e[1], s * a.e[2]}};
}
template <typename V>
HAZUMI_LANE_INLINE V Dot(const Triple<V>& a, const Triple<V>& b) {
  return a.e[0] * b.e[0] + a.e[1] * b.e[1] + a.e[2] * b.e[2];
}
template <typename V>
HAZUMI_LANE_INLINE Triple<V> Cross(const Triple<V>& a, const Triple<V>& b) {
  return {{a.e[1] * b.e[2] - a.e[2] * b.e[1], a.e[2] * b.e[0] - a.e[0] * b.e[2],
           a.e[0] * b.e[1] - a.e[1] * b.e[0]}};
}

// Symmetric 3 x 3: the diagonal, and o[k] the entry of the two indices other than k.
template <typename V>
struct Symmetric {
  V d[3], o[3];
};

template <typename V>
HAZUMI_LANE_INLINE Triple<V> operator*(const Symmetric<V>& S, const Triple<V>& x) {
  return {{S.d[0] * x.e[0] + S.o[2] * x.e[1] + S.o[1] * x.e[2],
           S.o[2] * x.e[0] + S.d[1] * x.e[1] + S.o[0] * x.e[2],
           S.o[1] * x.e[0] + S.o[0] * x.e[1] + S.d[2] * x.e[2]}};
}

template <int W, typename V = typename LanesOf<W>::Real>
HAZUMI_LANE_INLINE Triple<V> LoadTriple(const double* at) {
  return {{Load<W>(at), Load<W>(at + W), Load<W>(at + 2 * W)}};
}
template <int W, typename V = typename LanesOf<W>::Real>
HAZUMI_LANE_INLINE void StoreTriple(double* at, const Triple<V>& x) {
  for (int i = 0; i < 3; ++i) Store<W>(at + i * W, x.e[i]);
}
template <int W, typename V = typename LanesOf<W>::Real>
HAZUMI_LANE_INLINE Symmetric<V> LoadSymmetric(const double* at) {
  Symmetric<V> S;
  for (int i = 0; i < 3; ++i) S.d[i] = Load<W>(at + i * W);
  for (int i = 0; i < 3; ++i) S.o[i] = Load<W>(at + (3 + i) * W);
  return S;
}
