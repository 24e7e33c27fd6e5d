// The loops of DenseKernels, for the instruction set that the file that includes this is compiled
// for, in its own namespace. Every number is found by the same operations in the same order
// whatever the set: sums are four partial ones.

// What rounding leaves of a pivot that is zero: of its diagonal, and of the largest.
constexpr double kLost = 1e-13, kLostOfAll = 1e-17;

typedef double Four __attribute__((vector_size(32)));
// Four numbers at any address of a double. The alignment is that of the struct: clang drops the
// alignment of a typedef from references.
struct __attribute__((packed, aligned(8), may_alias)) FourAnywhere {
  Four v;
};

inline FourAnywhere& FourAt(double* x) { return *reinterpret_cast<FourAnywhere*>(x); }
inline const FourAnywhere& FourAt(const double* x) {
  return *reinterpret_cast<const FourAnywhere*>(x);
}

// y -= f x, from `first` on.
inline void Subtract(double f, const double* x, long first, long n, double* y) {
  long i = first;
  for (; i % 4 != 0 && i < n; ++i) y[i] -= f * x[i];
  for (; i + 4 <= n; i += 4) FourAt(y + i).v -= f * FourAt(x + i).v;
  for (; i < n; ++i) y[i] -= f * x[i];
}

// The same of four columns of A, one after the other, with `f` of them. By whole fours: what is
// before `first` in y may change.
inline void SubtractFour(const double* A, long stride, const double* f, long first, long n,
                         double* y) {
  const double *a = A, *b = a + stride, *c = b + stride, *d = c + stride;
  const double of_a = f[0], of_b = f[1], of_c = f[2], of_d = f[3];
  long i = first & ~3L;
  for (; i + 4 <= n; i += 4) {
    Four sum = FourAt(y + i).v;
    sum -= of_a * FourAt(a + i).v;
    sum -= of_b * FourAt(b + i).v;
    sum -= of_c * FourAt(c + i).v;
    sum -= of_d * FourAt(d + i).v;
    FourAt(y + i).v = sum;
  }
  for (; i < n; ++i) {
    y[i] = (((y[i] - of_a * a[i]) - of_b * b[i]) - of_c * c[i]) - of_d * d[i];
  }
}

inline void Scale(double f, long first, long n, double* y) {
  long i = first;
  for (; i % 4 != 0 && i < n; ++i) y[i] *= f;
  for (; i + 4 <= n; i += 4) FourAt(y + i).v *= f;
  for (; i < n; ++i) y[i] *= f;
}

// What is above the diagonal may change.
int Factor(double* A, long stride, long n) {
  int lost = 0;
  double largest = 0.0;
  for (long k = 0; k < n; ++k) largest = A[k * stride + k] > largest ? A[k * stride + k] : largest;
  for (long k = 0; k < n; ++k) {
    double* column = A + k * stride;
    const double diagonal = column[k];
    long j = 0;
    for (; j + 4 <= k; j += 4) {
      const double* a = A + j * stride + k;
      const double own[4] = {a[0], a[stride], a[2 * stride], a[3 * stride]};
      SubtractFour(A + j * stride, stride, own, k, n, column);
    }
    for (; j < k; ++j) Subtract(A[j * stride + k], A + j * stride, k, n, column);
    const double least =
        kLost * diagonal > kLostOfAll * largest ? kLost * diagonal : kLostOfAll * largest;
    if (column[k] > least) {
      const double root = __builtin_sqrt(column[k]), inverse = 1.0 / root;
      column[k] = root;
      Scale(inverse, k + 1, n, column);
    } else {
      for (long i = k; i < n; ++i) column[i] = 0.0;
      ++lost;
    }
  }
  return lost;
}

inline void Swap(double* x, double* y) {
  const double was = *x;
  *x = *y;
  *y = was;
}

// P A = L U column by column, each with the exchanges of rows before it.
void SolveGeneral(double* A, long stride, long n, long* exchanged, double* x) {
  for (long j = 0; j < n; ++j) {
    double* y = A + j * stride;
    for (long k = 0; k < j; ++k) Swap(y + k, y + exchanged[k]);
    long k = 0;
    for (; k + 4 <= j; k += 4) {
      const double* L = A + k * stride + k;
      double* u = y + k;
      u[1] -= L[1] * u[0];
      u[2] = (u[2] - L[2] * u[0]) - L[stride + 2] * u[1];
      u[3] = ((u[3] - L[3] * u[0]) - L[stride + 3] * u[1]) - L[2 * stride + 3] * u[2];
      SubtractFour(A + k * stride, stride, u, k + 4, n, y);
    }
    for (; k < j; ++k) Subtract(y[k], A + k * stride, k + 1, n, y);
    long largest = j;
    for (long i = j + 1; i < n; ++i) {
      if (__builtin_fabs(y[i]) > __builtin_fabs(y[largest])) largest = i;
    }
    exchanged[j] = largest;
    for (long c = 0; c <= j && largest != j; ++c) {
      Swap(A + c * stride + j, A + c * stride + largest);
    }
    Scale(1.0 / y[j], j + 1, n, y);
  }
  for (long k = 0; k < n; ++k) Swap(x + k, x + exchanged[k]);
  for (long k = 0; k < n; ++k) Subtract(x[k], A + k * stride, k + 1, n, x);
  for (long k = n - 1; k >= 0; --k) {
    x[k] /= A[k * stride + k];
    Subtract(x[k], A + k * stride, 0, k, x);
  }
}

// One column after the other.
void SolveLowerColumn(const double* L, long stride, long n, double* x) {
  for (long k = 0; k < n; ++k) {
    const double* column = L + k * stride;
    x[k] = column[k] > 0.0 ? x[k] / column[k] : 0.0;
    if (x[k] != 0.0) Subtract(x[k], column, k + 1, n, x);
  }
}

// Eight columns at once, n times eight numbers row by row.
void SolveLowerOfEight(const double* L, long stride, long n, Four* x) {
  for (long i = 0; i < n; ++i) {
    Four left = x[2 * i], right = x[2 * i + 1];
    for (long k = 0; k < i; ++k) {
      const double own = L[k * stride + i];
      left -= own * x[2 * k];
      right -= own * x[2 * k + 1];
    }
    const double pivot = L[i * stride + i];
    x[2 * i] = pivot > 0.0 ? left / pivot : Four{};
    x[2 * i + 1] = pivot > 0.0 ? right / pivot : Four{};
  }
}

void SolveLowerColumns(const double* L, long stride, long n, double* X, long x_stride, long count) {
  constexpr long kMostRows = 128, kFewest = 3;
  Four block[2 * kMostRows];
  long j = 0;
  for (; n <= kMostRows && j + kFewest <= count; j += 8) {
    double* x[8];  // where there are less, the last one again
    for (long c = 0; c < 8; ++c) x[c] = X + (j + c < count ? j + c : count - 1) * x_stride;
    for (long i = 0; i < n; ++i) {
      block[2 * i] = Four{x[0][i], x[1][i], x[2][i], x[3][i]};
      block[2 * i + 1] = Four{x[4][i], x[5][i], x[6][i], x[7][i]};
    }
    SolveLowerOfEight(L, stride, n, block);
    for (long i = 0; i < n; ++i) {
      const Four &left = block[2 * i], &right = block[2 * i + 1];
      for (long c = 0; c < 4; ++c) x[c][i] = left[c];
      for (long c = 0; c < 4; ++c) x[4 + c][i] = right[c];
    }
  }
  for (; j < count; ++j) SolveLowerColumn(L, stride, n, X + j * x_stride);
}

// y -= a f_0 + b f_1 + c f_2, f_i the columns of F.
void SubtractThree(const double* F, long stride, const double* abc, long n, double* y) {
  const double a = abc[0], b = abc[1], c = abc[2];
  const double *f = F, *g = F + stride, *h = F + 2 * stride;
  long i = 0;
  for (; i + 4 <= n; i += 4) {
    FourAt(y + i).v -= (FourAt(f + i).v * a + FourAt(g + i).v * b) + FourAt(h + i).v * c;
  }
  for (; i < n; ++i) y[i] -= (f[i] * a + g[i] * b) + h[i] * c;
}

// The same; what is left of it to rounding is nothing.
void SubtractThreeRounded(const double* F, long stride, const double* abc, long n, double* y) {
  constexpr double kRounding = 1e-14;
  const double a = abc[0], b = abc[1], c = abc[2];
  const double *f = F, *g = F + stride, *h = F + 2 * stride;
  long i = 0;
  for (; i + 4 <= n; i += 4) {
    const Four part = (FourAt(f + i).v * a + FourAt(g + i).v * b) + FourAt(h + i).v * c;
    const Four left = FourAt(y + i).v - part, none = {};
    const Four size = part < none ? -part : part, of_left = left < none ? -left : left;
    FourAt(y + i).v = of_left <= kRounding * size ? none : left;
  }
  for (; i < n; ++i) {
    const double part = (f[i] * a + g[i] * b) + h[i] * c, left = y[i] - part;
    const double size = part < 0.0 ? -part : part, of_left = left < 0.0 ? -left : left;
    y[i] = of_left <= kRounding * size ? 0.0 : left;
  }
}

// y += (a j_0 + b j_1 + c j_2) - (d f_0 + e f_1 + f f_2), j_i and f_i the columns of J and F.
void AddThrees(const double* J, const double* F, long stride, const double* abc, const double* def,
               long n, double* y) {
  const double a = abc[0], b = abc[1], c = abc[2], d = def[0], e = def[1], f = def[2];
  const double *j0 = J, *j1 = J + stride, *j2 = J + 2 * stride;
  const double *f0 = F, *f1 = F + stride, *f2 = F + 2 * stride;
  long i = 0;
  for (; i + 4 <= n; i += 4) {
    const Four of_J = (FourAt(j0 + i).v * a + FourAt(j1 + i).v * b) + FourAt(j2 + i).v * c;
    const Four of_F = (FourAt(f0 + i).v * d + FourAt(f1 + i).v * e) + FourAt(f2 + i).v * f;
    FourAt(y + i).v += of_J - of_F;
  }
  for (; i < n; ++i) {
    y[i] += ((j0[i] * a + j1[i] * b) + j2[i] * c) - ((f0[i] * d + f1[i] * e) + f2[i] * f);
  }
}

inline double SumOf(const Four& x) { return (x[0] + x[2]) + (x[1] + x[3]); }

inline double Dot(const double* x, const double* y, long n) {
  Four sum = {};
  long i = 0;
  for (; i + 4 <= n; i += 4) sum += FourAt(x + i).v * FourAt(y + i).v;
  double rest = 0.0;
  for (; i < n; ++i) rest += x[i] * y[i];
  return SumOf(sum) + rest;
}

// Two columns of X with two of Y, as Dot.
inline void Dot2x2(const double* x, long x_stride, const double* y, long y_stride, long n,
                   double* C, long c_stride) {
  Four s00 = {}, s01 = {}, s10 = {}, s11 = {};
  long i = 0;
  for (; i + 4 <= n; i += 4) {
    const Four x0 = FourAt(x + i).v, x1 = FourAt(x + x_stride + i).v;
    const Four y0 = FourAt(y + i).v, y1 = FourAt(y + y_stride + i).v;
    s00 += x0 * y0;
    s01 += x0 * y1;
    s10 += x1 * y0;
    s11 += x1 * y1;
  }
  double r00 = 0.0, r01 = 0.0, r10 = 0.0, r11 = 0.0;
  for (; i < n; ++i) {
    r00 += x[i] * y[i];
    r01 += x[i] * y[y_stride + i];
    r10 += x[x_stride + i] * y[i];
    r11 += x[x_stride + i] * y[y_stride + i];
  }
  C[0] = SumOf(s00) + r00;
  C[1] = SumOf(s10) + r10;
  C[c_stride] = SumOf(s01) + r01;
  C[c_stride + 1] = SumOf(s11) + r11;
}

void Product(const double* X, long x_stride, long columns, const double* Y, long y_stride,
             long rows, long n, double* C, long c_stride) {
  const bool is_symmetric = X == Y && columns == rows;
  for (long b = 0; b < rows; b += 2) {
    for (long a = is_symmetric ? b : 0; a < columns; a += 2) {
      const double *x = X + a * x_stride, *y = Y + b * y_stride;
      double* c = C + b * c_stride + a;
      if (a + 2 <= columns && b + 2 <= rows) {
        Dot2x2(x, x_stride, y, y_stride, n, c, c_stride);
        continue;
      }
      for (long j = 0; j < 2 && b + j < rows; ++j) {
        for (long i = 0; i < 2 && a + i < columns; ++i) {
          c[j * c_stride + i] = Dot(x + i * x_stride, y + j * y_stride, n);
        }
      }
    }
  }
  for (long b = 0; b < rows && is_symmetric; ++b) {
    for (long a = b + 1; a < columns; ++a) C[a * c_stride + b] = C[b * c_stride + a];
  }
}
