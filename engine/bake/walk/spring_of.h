#pragma once

#include "engine/bake/handover/region_start.h"
#include "engine/passive/forces/spring_drive.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

// The spring that `drive` is to a joint of a region that began so.
Spring SpringOf(const Drive& drive, JointIndex joint, const DynamicsRegion& region,
                const Figure& figure, const RegionStart& start, FrameRate rate);

}  // namespace hazumi
