#pragma once

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Where it is: "region \"arm\" begins", "placement 0 ends".
std::string BorderText(const Animation& animation, const Seam& seam);
// What would take it away, as a clause; empty for jumps of accelerations alone, which any change of
// what drives a joint makes.
std::string MendText(SeamMend mend);

// How much a jump of position or rate shows [rad/s], a metre counting as a radian and a position as
// what it would be within a thirtieth of a second; less than 1e-6 is none.
double SizeOf(const Seam& seam);
inline constexpr double kNoSeam = 1e-6;  // [rad/s]

// The largest jumps of position and rate, so many at most, a line each; where there are none the
// largest of the accelerations. Nothing without borders.
std::vector<std::string> SeamReport(const Animation& animation, const std::vector<Seam>& seams,
                                    size_t most = 5);

}  // namespace hazumi
