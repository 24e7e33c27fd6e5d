#pragma once

#include "engine/base/typed_index.h"

namespace hazumi {

// A hinge of a figure. The invalid index stands for the root body where a parent is meant.
using JointIndex = TypedIndex<struct JointTag>;

// One to three concentric hinges that the animator sees as one joint ("r_shoulder").
using GroupIndex = TypedIndex<struct GroupTag>;

}  // namespace hazumi
