#include "engine/analysis/touch_lanes.h"

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

  // a D D^T + b E E^T
  template <int Row, int Column>
  HAZUMI_LANE_INLINE void AddColumn(const LaneReal* D, const LaneReal* E, LaneReal aD,
                                    LaneReal bE) {
    slope(Row, Column) += aD * D[Row] + bE * E[Row];
    if constexpr (Row < 5) AddColumn<Row + 1, Column>(D, E, aD, bE);
  }
  template <int Column = 0>
  HAZUMI_LANE_INLINE void AddSquares(LaneReal a, const LaneReal* D, LaneReal b, const LaneReal* E) {
    AddColumn<Column, Column>(D, E, a * D[Column], b * E[Column]);
    if constexpr (Column < 5) AddSquares<Column + 1>(a, D, b, E);
  }

  // w G G^T = w (1, -[r]; [r], r^2 1 - r r^T)
  HAZUMI_LANE_INLINE void AddWhole(LaneReal w, const LaneTriple& r) {
    const LaneTriple wr = Scaled(w, r);
    const LaneReal xx = wr.e[0] * r.e[0], yy = wr.e[1] * r.e[1], zz = wr.e[2] * r.e[2];
    slope(0, 0) += w;
    slope(1, 1) += w;
    slope(2, 2) += w;
    slope(3, 1) -= wr.e[2];
    slope(3, 2) += wr.e[1];
    slope(4, 0) += wr.e[2];
    slope(4, 2) -= wr.e[0];
    slope(5, 0) -= wr.e[1];
    slope(5, 1) += wr.e[0];
    slope(3, 3) += yy + zz;
    slope(4, 4) += xx + zz;
    slope(5, 5) += xx + yy;
    slope(4, 3) -= wr.e[0] * r.e[1];
    slope(5, 3) -= wr.e[0] * r.e[2];
    slope(5, 4) -= wr.e[1] * r.e[2];
  }
};

template <bool WantsSlope>
HAZUMI_LANE_INLINE bool SumUp(const double* given, int num_fours, const double* y, double friction,
                              bool keeps, double* found, double* sums_out) {
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
    const LaneBits pin = LoadBits(at + 4 * ConeField::kPinBits);

    const LaneTriple u = a + Cross(c, arm);
    const LaneReal n = Dot(u, normal);
    const LaneTriple tangential = u + Scaled(-n, normal);
    const LaneReal t2 = Dot(tangential, tangential), n2 = n * n;
    const LaneBits is_inside = pin | (~Greater(zero, n) & ~Greater(t2, mu2 * n2));
    const LaneBits is_polar = ~Greater(n, zero) & ~Greater(mu2 * t2, n2);
    const LaneBits is_side = ~(is_inside | is_polar);
    // Without a tangential force there is no side that it could be kept on.
    const LaneBits has_side = Greater(t2, zero), kept = keeping & has_side & ~pin;
    const LaneBits inside =
        (LoadBits(own + 4 * ConeField::kInsideBits) & kept) | (is_inside & ~kept);
    const LaneBits side = (LoadBits(own + 4 * ConeField::kSideBits) & kept) | (is_side & ~kept);
    wrong |= (inside ^ is_inside) | (side ^ is_side);
    StoreBits(own + 4 * ConeField::kInsideBits, inside);
    StoreBits(own + 4 * ConeField::kSideBits, side);

    const LaneReal t = SquareRoot(t2 + Only(one, ~has_side));
    const LaneTriple along = Scaled(one / t, tangential);
    const LaneReal size = (n + mu * t) * share;
    const LaneTriple d = normal + Scaled(mu, along), e = Cross(normal, along);
    const LaneTriple f = Scaled(w, Only(u, inside) + Only(Scaled(size, d), side));
    StoreTriple<4>(own + 4 * ConeField::kForce, f);
    sums.AddForce(arm, f);
    sums.of[ConeField::kPotential] += 0.5 * Dot(f, u);
    if constexpr (!WantsSlope) continue;
    const LaneTriple arm_d = Cross(arm, d), arm_e = Cross(arm, e);
    const LaneReal D[6] = {d.e[0], d.e[1], d.e[2], arm_d.e[0], arm_d.e[1], arm_d.e[2]};
    const LaneReal E[6] = {e.e[0], e.e[1], e.e[2], arm_e.e[0], arm_e.e[1], arm_e.e[2]};
    sums.AddSquares(Only(w * share, side), D, Only(w * mu * size / t, side & Greater(size, zero)),
                    E);
    sums.AddWhole(Only(w, inside), arm);
  }
  for (int k = 0; k < ConeField::kNumSums; ++k) Store<4>(sums_out + 4 * k, sums.of[k]);
  const bool is_right = !AnySet(wrong);
  LeaveLanes();
  return is_right;
}

bool Supply(const double* given, int num_fours, const double* y, double friction, bool keeps,
            bool wants_slope, double* found, double* sums) {
  return wants_slope ? SumUp<true>(given, num_fours, y, friction, keeps, found, sums)
                     : SumUp<false>(given, num_fours, y, friction, keeps, found, sums);
}
