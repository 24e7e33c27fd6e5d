#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/placement/figure_motion.h"

namespace hazumi {

// Two links of a figure, by their indices in Figure::links, a < b.
struct LinkPair {
  int a = 0, b = 0;
};

// Pairs of links that can be kept apart. The links belong to different joints, neither of which is
// the parent of the other, and they are apart when all angles are zero. `with_touching` includes
// pairs that just touch.
std::vector<LinkPair> PairsApart(const Figure& figure, bool with_touching = true);

// The pair that is deepest inside each other; none if they are all apart. Needs ComputePositions.
struct Overlap {
  LinkPair pair;
  double depth = 0.0;  // [m]
};
std::optional<Overlap> DeepestOverlap(const std::vector<LinkPair>& pairs, const Figure& figure,
                                      const DynamicsWorkspace& ws);

// Says which pair that is, and what happens then; none is told of if none is deeper than a tenth of
// a millimetre.
std::optional<std::string> TellOfOverlap(const std::vector<LinkPair>& pairs, const Figure& figure,
                                         const FigureMotion& motion, DynamicsWorkspace* ws);

}  // namespace hazumi
