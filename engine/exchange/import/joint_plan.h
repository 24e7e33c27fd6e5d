#pragma once

// Internal. What the bones of a skeleton become: joints of up to three hinges each, in Hazumi's
// axes and metres, and their angles at each frame of a clip.

#include <array>
#include <string>
#include <vector>

#include "engine/exchange/import/import_project.h"
#include "engine/exchange/import/skeleton.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi {

// Frames: a body's axes are those of its bone, turned into the world's axes; at rest the root's are
// the world's own.
struct PlannedJoint {
  std::string name;
  int parent = -1;  // index of a kept bone; -1: this is the root
  Vec3 offset = Vec3::Zero();
  Mat3 orientation = Mat3::Identity();
  EulerAxes axes = {0, 1, 2};  // of the hinges, from the parent out
  int num_hinges = 3;
  std::vector<Vec3> angles;  // by frame [rad]
};

struct FigurePlan {
  std::vector<PlannedJoint> joints;  // by kept bone; the first one is the root
  std::vector<Vec3> root_position;   // by frame [m]
  std::vector<Vec3> root_angles;     // by frame, z, y, x [rad]
};

// Without a clip there is one frame: at rest. What moves a bone in its parent is dropped, with a
// warning that names it and its range.
FigurePlan PlanFigure(const Character& character, const Skeleton& skeleton, const Clip* clip,
                      const WorldFrame& world, ImportReport* report);

// The bodies at a frame, in the world [m], by kept bone.
std::vector<Pose> BodiesOf(const FigurePlan& plan, int frame);

// The same, all angles zero and the root at the origin.
std::vector<Pose> RestBodies(const FigurePlan& plan);

// Where each joint is at a frame [m], by kept bone.
std::vector<Vec3> PositionsOf(const FigurePlan& plan, int frame);

// The same of the file's own bones, with all that moves them.
std::vector<Vec3> FilePositions(const Character& character, const Skeleton& skeleton,
                                const Clip* clip, const WorldFrame& world, int frame);

}  // namespace hazumi
