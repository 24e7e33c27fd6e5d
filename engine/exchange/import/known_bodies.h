#pragma once

// Internal. The links of a figure that Hazumi has written itself.

#include <optional>
#include <vector>

#include "engine/exchange/import/skeleton.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// By kept bone, with their masses; none unless the file says what hangs on each of them. In another
// unit than the file's they are as dense as they were. `mass`: of all together [kg], if it is asked
// for.
std::optional<std::vector<std::vector<LinkSpec>>> KnownLinks(const Character& character,
                                                             const Skeleton& skeleton,
                                                             const WorldFrame& world,
                                                             std::optional<double> mass);

}  // namespace hazumi
