#pragma once

namespace hazumi {

inline constexpr double kDegree = 3.14159265358979323846 / 180.0;  // [rad]

// An angle in degrees: of the numbers that give these radians back, the one with the fewest digits,
// so that 15 is not written as 14.999999999999998; where no number does, the quotient.
double ShortestDegrees(double radians);

// The angle with as many whole turns more or less as bring it nearest to another one [rad].
double NearestTurn(double angle, double to);

}  // namespace hazumi
