#pragma once

#include "engine/figure/figure.h"

namespace hazumi::bench {

// Hinges about x and y in turn, with equal rods between them.
Figure Chain(int joints);

// The same rods, two on the end of each.
Figure BinaryTree(int joints);

}  // namespace hazumi::bench
