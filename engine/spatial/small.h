#pragma once

#include "engine/spatial/types.h"

// Three-vectors and 3 x 3 matrices for the innermost loops: plain structs whose operations are
// always inlined, which g++ does not do for Eigen's products. Same conventions as types.h.

#if defined(__GNUC__)
#define HAZUMI_INLINE inline __attribute__((always_inline))
#else
#define HAZUMI_INLINE inline
#endif

namespace hazumi::small {

struct V3 {
  double x = 0.0, y = 0.0, z = 0.0;
  V3() = default;
  HAZUMI_INLINE V3(double a, double b, double c) : x(a), y(b), z(c) {}
  // Number by number: a copy in pieces of other sizes has to wait for what was just written.
  HAZUMI_INLINE V3(const V3& v) : x(v.x), y(v.y), z(v.z) {}
  HAZUMI_INLINE V3& operator=(const V3& v) {
    x = v.x;
    y = v.y;
    z = v.z;
    return *this;
  }
  HAZUMI_INLINE V3(const Vec3& v) : x(v[0]), y(v[1]), z(v[2]) {}  // NOLINT: the same thing
  Vec3 eigen() const { return {x, y, z}; }
};

HAZUMI_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HAZUMI_INLINE V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HAZUMI_INLINE V3 operator-(const V3& a) { return {-a.x, -a.y, -a.z}; }
HAZUMI_INLINE V3 operator*(double s, const V3& a) { return {s * a.x, s * a.y, s * a.z}; }
HAZUMI_INLINE V3& operator+=(V3& a, const V3& b) { return a = a + b; }
HAZUMI_INLINE V3& operator-=(V3& a, const V3& b) { return a = a - b; }
HAZUMI_INLINE double Dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HAZUMI_INLINE V3 Cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Symmetric.
struct S3 {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  S3() = default;
  HAZUMI_INLINE S3(double a, double b, double c, double d, double e, double f)
      : xx(a), xy(b), xz(c), yy(d), yz(e), zz(f) {}
  HAZUMI_INLINE S3(const S3& s) : S3(s.xx, s.xy, s.xz, s.yy, s.yz, s.zz) {}
  HAZUMI_INLINE S3& operator=(const S3& s) {
    xx = s.xx;
    xy = s.xy;
    xz = s.xz;
    yy = s.yy;
    yz = s.yz;
    zz = s.zz;
    return *this;
  }
};
HAZUMI_INLINE S3 operator+(const S3& a, const S3& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
HAZUMI_INLINE S3& operator+=(S3& a, const S3& b) { return a = a + b; }
HAZUMI_INLINE V3 operator*(const S3& a, const V3& v) {
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.xz * v.x + a.yz * v.y + a.zz * v.z};
}
HAZUMI_INLINE S3 Diagonal(double d) { return {d, 0.0, 0.0, d, 0.0, d}; }
// a -= u v^T, for u v^T symmetric.
HAZUMI_INLINE void SubtractOuter(S3& a, const V3& u, const V3& v) {
  a.xx -= u.x * v.x;
  a.xy -= u.x * v.y;
  a.xz -= u.x * v.z;
  a.yy -= u.y * v.y;
  a.yz -= u.y * v.z;
  a.zz -= u.z * v.z;
}

// By columns.
struct M3 {
  V3 a, b, c;
  Mat3 eigen() const {
    Mat3 m;
    m << a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z;
    return m;
  }
};
HAZUMI_INLINE M3 ToSmall(const Mat3& m) {
  return {{m(0, 0), m(1, 0), m(2, 0)}, {m(0, 1), m(1, 1), m(2, 1)}, {m(0, 2), m(1, 2), m(2, 2)}};
}
HAZUMI_INLINE S3 ToSymmetric(const Mat3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}
HAZUMI_INLINE M3 operator+(const M3& p, const M3& q) { return {p.a + q.a, p.b + q.b, p.c + q.c}; }
HAZUMI_INLINE M3& operator+=(M3& p, const M3& q) { return p = p + q; }
HAZUMI_INLINE V3 operator*(const M3& m, const V3& v) { return v.x * m.a + v.y * m.b + v.z * m.c; }
HAZUMI_INLINE M3 operator*(const M3& p, const M3& q) { return {p * q.a, p * q.b, p * q.c}; }
HAZUMI_INLINE V3 TransposeTimes(const M3& m, const V3& v) {
  return {Dot(m.a, v), Dot(m.b, v), Dot(m.c, v)};
}
// a -= u v^T
HAZUMI_INLINE void SubtractOuter(M3& m, const V3& u, const V3& v) {
  m.a -= v.x * u;
  m.b -= v.y * u;
  m.c -= v.z * u;
}
// R S R^T
HAZUMI_INLINE S3 Rotated(const M3& R, const S3& s) {
  const V3 p = s.xx * R.a + s.xy * R.b + s.xz * R.c;  // columns of R S
  const V3 q = s.xy * R.a + s.yy * R.b + s.yz * R.c;
  const V3 r = s.xz * R.a + s.yz * R.b + s.zz * R.c;
  return {p.x * R.a.x + q.x * R.b.x + r.x * R.c.x, p.x * R.a.y + q.x * R.b.y + r.x * R.c.y,
          p.x * R.a.z + q.x * R.b.z + r.x * R.c.z, p.y * R.a.y + q.y * R.b.y + r.y * R.c.y,
          p.y * R.a.z + q.y * R.b.z + r.y * R.c.z, p.z * R.a.z + q.z * R.b.z + r.z * R.c.z};
}

}  // namespace hazumi::small
