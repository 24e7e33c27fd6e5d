#pragma once

// Internal. Coefficients of the explicit Runge-Kutta method of order 5 with an error estimate of
// order 4 and dense output of order 4 [Hairer, Norsett, Wanner 1993, II.5 and II.6]. The last stage
// is the first one of the next step.

namespace hazumi::dopri5 {

constexpr double kC[7] = {0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0};
inline constexpr double kA[7][6] = {
    {0.0},
    {1.0 / 5.0},
    {3.0 / 40.0, 9.0 / 40.0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
};
constexpr double kE4[7] = {71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                           -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
constexpr double kD[7] = {-12715105075.0 / 11282082432.0,  0.0,
                          87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
                          701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
                          69997945.0 / 29380423.0};

}  // namespace hazumi::dopri5
