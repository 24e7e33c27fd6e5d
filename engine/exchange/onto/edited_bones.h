#pragma once

// Internal. Bones of a file whose motion a project has changed.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/exchange/import/import_project.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Lists by frame of EditedClip. In the frame of the node above, unit of the file.
struct EditedBone {
  std::string name;
  int node = -1;                              // BoneSource::node
  std::vector<Eigen::Quaterniond> rotations;  // empty: as the file has them
  std::vector<Vec3> translations;             // empty: as the file has them
  std::vector<char> is_changed;               // else both are the file's
};

struct EditedClip {
  int index = -1;  // of the file's clips; -1: it has none
  std::string name;
  int first = 0, num_frames = 0;  // frame 0 is the clip's first
  double start_s = 0.0, seconds_per_frame = 0.0;
  int num_source_frames = 0;
  std::vector<EditedBone> bones;
};

// `source`: read at the rate of the motion, with `how` as it was imported. Frames of the clip that
// the motion has not are as in the file. Errors, kSemantics: the figure has not the joints that
// such an import has; a node that cannot be turned so.
Result<EditedClip> EditedBonesOf(const Character& source, const ImportOptions& how,
                                 const Figure& figure, const Motion& motion);

}  // namespace hazumi
