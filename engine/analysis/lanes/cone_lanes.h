#include "engine/analysis/lanes/touch_lanes.h"

// Forces in cones of friction, a contact in each lane: contact_forces.cpp has the equations.

HAZUMI_LANE_INLINE LaneBits LoadBits(const double* at) { return SameBits<LaneBits>(Load<4>(at)); }
HAZUMI_LANE_INLINE void StoreBits(double* at, LaneBits bits) {
  Store<4>(at, SameBits<LaneReal>(bits));
}

// Where it is of the lower half of a symmetric 6 x 6, by columns.
constexpr int LowerIndex(int row, int column) {
  return ConeField::kSlope + column * 6 - column * (column - 1) / 2 + row - column;
}

// The sums of contacts so far.
struct ConeSums {
  LaneReal of[ConeField::kNumSums];

  HAZUMI_LANE_INLINE LaneReal& slope(int row, int column) { return of[LowerIndex(row, column)]; }

  HAZUMI_LANE_INLINE void AddForce(const LaneTriple& arm, const LaneTriple& f) {
    const LaneTriple moment = Cross(arm, f);
    for (int k = 0; k < 3; ++k) {
      of[ConeField::kSupplied + k] += f.e[k];
      of[ConeField::kSupplied + 3 + k] += moment.e[k];
    }
  }

  // G M G^T, G = (1; [r]), M symmetric: with B = [r] M, the rest is [r] M [r]^T = -B [r].
  HAZUMI_LANE_INLINE void AddSlope(const LaneTriple& r, const Symmetric<LaneReal>& M) {
    const LaneTriple columns[3] = {Cross(r, {{M.d[0], M.o[2], M.o[1]}}),
                                   Cross(r, {{M.o[2], M.d[1], M.o[0]}}),
                                   Cross(r, {{M.o[1], M.o[0], M.d[2]}})};
    for (int k = 0; k < 3; ++k) {
      slope(k, k) += M.d[k];
      for (int i = 0; i < 3; ++i) slope(3 + i, k) += columns[k].e[i];
    }
    slope(1, 0) += M.o[2];
    slope(2, 0) += M.o[1];
    slope(2, 1) += M.o[0];
    const auto B = [&](int row, int column) { return columns[column].e[row]; };
    for (int i = 0; i < 3; ++i) slope(3 + i, 3) += r.e[1] * B(i, 2) - r.e[2] * B(i, 1);
    for (int i = 1; i < 3; ++i) slope(3 + i, 4) += r.e[2] * B(i, 0) - r.e[0] * B(i, 2);
    slope(5, 5) += r.e[0] * B(2, 1) - r.e[1] * B(2, 0);
  }
};

// a d d^T + b e e^T + c 1
HAZUMI_LANE_INLINE Symmetric<LaneReal> SlopeOfForce(LaneReal a, const LaneTriple& d, LaneReal b,
                                                    const LaneTriple& e, LaneReal c) {
  const LaneTriple ad = Scaled(a, d), be = Scaled(b, e);
  Symmetric<LaneReal> M;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    M.d[k] = ad.e[k] * d.e[k] + be.e[k] * e.e[k] + c;
    M.o[k] = ad.e[i] * d.e[j] + be.e[i] * e.e[j];
  }
  return M;
}

bool Supply(const double* given, int num_fours, const double* y, double friction, bool keeps,
            double* found, double* sums_out) {
  const LaneTriple a = {{All(y[0]), All(y[1]), All(y[2])}}, c = {{All(y[3]), All(y[4]), All(y[5])}};
  const LaneReal mu = All(friction), mu2 = mu * mu, one = All(1.0), share = one / (one + mu2);
  const LaneReal zero = All(0.0);
  const LaneBits all = Greater(one, zero);
  const LaneBits keeping = keeps ? all : ~all;
  ConeSums sums;
  for (LaneReal& sum : sums.of) sum = zero;
  LaneBits wrong = ~all;
  for (int four = 0; four < num_fours; ++four) {
    const double* at = given + 4 * ConeField::kNumGiven * four;
    double* own = found + 4 * ConeField::kNumFound * four;
    const LaneTriple arm = LoadTriple<4>(at + 4 * ConeField::kArm);
    const LaneTriple normal = LoadTriple<4>(at + 4 * ConeField::kNormal);
    const LaneReal w = Load<4>(at + 4 * ConeField::kWeight);
    const LaneBits grip = LoadBits(at + 4 * ConeField::kGripBits);

    const LaneTriple u = a + Cross(c, arm);
    const LaneReal n = Dot(u, normal);
    const LaneTriple tangential = u + Scaled(-n, normal);
    const LaneReal t2 = Dot(tangential, tangential), n2 = n * n;
    const LaneBits is_inside = grip | (~Greater(zero, n) & ~Greater(t2, mu2 * n2));
    const LaneBits is_polar = ~Greater(n, zero) & ~Greater(mu2 * t2, n2);
    const LaneBits is_side = ~(is_inside | is_polar);
    // Without a tangential force there is no side that it could be kept on.
    const LaneBits has_side = Greater(t2, zero), kept = keeping & has_side & ~grip;
    const LaneBits inside =
        (LoadBits(own + 4 * ConeField::kInsideBits) & kept) | (is_inside & ~kept);
    const LaneBits side = (LoadBits(own + 4 * ConeField::kSideBits) & kept) | (is_side & ~kept);
    wrong |= (inside ^ is_inside) | (side ^ is_side);
    StoreBits(own + 4 * ConeField::kInsideBits, inside);
    StoreBits(own + 4 * ConeField::kSideBits, side);

    const LaneReal t = SquareRoot(t2 + Only(one, ~has_side)), per_t = one / t;
    const LaneTriple along = Scaled(per_t, tangential);
    const LaneReal size = (n + mu * t) * share;
    const LaneTriple d = normal + Scaled(mu, along), e = Cross(normal, along);
    const LaneTriple f = Scaled(w, Only(u, inside) + Only(Scaled(size, d), side));
    StoreTriple<4>(own + 4 * ConeField::kForce, f);
    sums.AddForce(arm, f);
    sums.of[ConeField::kPotential] += 0.5 * Dot(f, u);
    const LaneReal turning = Only(w * mu * size * per_t, side & Greater(size, zero));
    sums.AddSlope(arm, SlopeOfForce(Only(w * share, side), d, turning, e, Only(w, inside)));
  }
  for (int k = 0; k < ConeField::kNumSums; k += 4) {
    Store<4>(sums_out + k, SumsOf(sums.of[k], sums.of[k + 1], sums.of[k + 2], sums.of[k + 3]));
  }
  const bool is_right = !AnySet(wrong);
  LeaveLanes();
  return is_right;
}

constexpr int kUnknowns = 6;

// A = L D L^T; of A's columns L D is left, of x L^-1 b.
template <int K = 0, int Column = K + 1>
HAZUMI_LANE_INLINE void Eliminate(double (*A)[kUnknowns], double* inverse, double* x) {
  if constexpr (Column == K + 1) inverse[K] = 1.0 / A[K][K];
  if constexpr (Column < kUnknowns) {
    const double l = inverse[K] * A[K][Column];
    for (int row = Column; row < kUnknowns; ++row) A[Column][row] -= l * A[K][row];
    x[Column] -= x[K] * l;
    Eliminate<K, Column + 1>(A, inverse, x);
  } else if constexpr (K + 1 < kUnknowns) {
    Eliminate<K + 1>(A, inverse, x);
  }
}
template <int K = kUnknowns - 1>
HAZUMI_LANE_INLINE void Substitute(const double (*A)[kUnknowns], const double* inverse, double* x) {
  for (int row = K + 1; row < kUnknowns; ++row) x[K] -= A[K][row] * x[row];
  x[K] *= inverse[K];
  if constexpr (K > 0) Substitute<K - 1>(A, inverse, x);
}

void Solve(const double* lower, double softness, double* x_out) {
  double A[kUnknowns][kUnknowns], inverse[kUnknowns], x[kUnknowns];  // A by columns
  for (int column = 0; column < kUnknowns; ++column) {
    for (int row = column; row < kUnknowns; ++row) A[column][row] = *lower++;
    A[column][column] += softness;
    x[column] = x_out[column];
  }
  Eliminate(A, inverse, x);
  Substitute(A, inverse, x);
  for (int k = 0; k < kUnknowns; ++k) x_out[k] = x[k];
  LeaveLanes();
}
