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
// Checks that no region moves joints, and no fill makes keys, in frames first to last. `instead`:
// advice. Errors: kSchema.
std::optional<Error> CheckFreeOfRegions(int first, int last, const std::string& instead,
                                        const Project& project);

// A hinge of the figure, and its share of what one of the human does in a move.
template <typename Hinge>
struct NamedHinge {
  std::string name;
  JointIndex joint;
  Hinge hinge;
};

// Adds what a hinge of the figure does of one of the human; a hinge that does several does their
// sum.
template <typename Hinge>
void AddShare(const HingeShare& share, Hinge hinge, const Figure& figure,
              std::vector<NamedHinge<Hinge>>* all) {
  hinge.Scale(share.share);
  for (NamedHinge<Hinge>& known : *all) {
    if (known.joint == share.hinge) return known.hinge.Add(hinge);
  }
  all->push_back({figure.joint(share.hinge).name, share.hinge, hinge});
}

// Keys a joint [deg, deg/s] or the root's place [m, m/s].
void KeyMove(int frame, double value, std::optional<double> rate, ProjectCurve* curve);
// Returns so many seconds in frames, at least `least`.
int FramesOf(double seconds, int least, const Animation& animation);

}  // namespace hazumi::makers
