#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

// Inserts a span of placement; earlier spans lose its frames. If not `is_said`, nothing is
// inserted: the root's keys place the figure there. Errors: kSchema if the span has no frames.
Result<Done> PutPlacement(ProjectPlacement span, bool is_said,
                          std::vector<ProjectPlacement>* spans);

}  // namespace hazumi
