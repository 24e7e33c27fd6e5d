#pragma once

namespace hazumi {

// From 0 at 0 to 1 at 1, with two derivatives that are 0 at both ends.
inline double SmoothStep(double s) { return s * s * s * (10.0 + s * (-15.0 + 6.0 * s)); }

}  // namespace hazumi
