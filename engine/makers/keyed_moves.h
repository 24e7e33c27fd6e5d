#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/body/figure_body.h"
#include "engine/figure/figure.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Checks that a figure has hinges that do what these of the human do, without which there is no
// such move. `whose`: its name, as "throw". Errors: kSchema.
std::optional<Error> CheckBody(const std::vector<std::string>& human_hinges,
                               const std::string& whose, const Figure& figure);
// Returns the joint on which a figure stands on a side: its toe, foot or shin. Empty: none.
std::string StandingJoint(const FigureBody& body, BodySide side, const Figure& figure);
// Checks that no region moves joints in frames first to last. `instead`: advice. Errors: kSchema.
std::optional<Error> CheckFreeOfRegions(int first, int last, const std::string& instead,
                                        const Project& project);

// Keys a joint [deg, deg/s] or the root's place [m, m/s].
void KeyMove(int frame, double value, std::optional<double> rate, ProjectCurve* curve);
// Returns so many seconds in frames, at least `least`.
int FramesOf(double seconds, int least, const Animation& animation);

}  // namespace hazumi::makers
