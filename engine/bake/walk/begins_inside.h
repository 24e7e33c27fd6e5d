#pragma once

#include <optional>
#include <string>

#include "engine/dynamics/workspace.h"
#include "engine/placement/contact.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Says which link that counts is deepest inside the scene where its region begins, and what happens
// then; none is told of if none is deeper than a tenth of a millimetre.
std::optional<std::string> TellOfInside(const Animation& animation, const Figure& figure,
                                        const FigureMotion& motion, const CountsContact& counts,
                                        DynamicsWorkspace* ws);

// Reports the same for a ball that is released with its centre there, world [m].
std::optional<std::string> TellOfInside(const Animation& animation, const HeldObject& ball,
                                        const Vec3& center, double frame);

}  // namespace hazumi
