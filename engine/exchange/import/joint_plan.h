#pragma once

// Internal. What the bones of a skeleton become: joints of up to three hinges each, in Hazumi's
// axes and metres, and their angles at each frame of a clip.

#include <array>
#include <string>
#include <vector>

#include "engine/exchange/import/body_hinges.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/import/skeleton.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/spatial/euler_angles.h"

namespace hazumi {

// Frames: a body's axes are those of its bone, turned into the world's axes; at rest the root's are
// the world's own. All angles zero, a body stands upright with its arms hanging (body_axes.h);
// other joints are at rest.
struct PlannedJoint {
  std::string name;
  int parent = -1;  // index of a kept bone; -1: this is the root
  Vec3 offset = Vec3::Zero();
  Mat3 orientation = Mat3::Identity();
  // R = orientation frame E frame^T in the parent's frame, with E the turn by `signs` times the
  // angles about `axes`, from the parent out: its hinges are along the frame's axes.
  Mat3 frame = Mat3::Identity();
  EulerAxes axes = {0, 1, 2};
  Vec3 signs = Vec3::Ones();
  int num_hinges = 3;
  std::vector<Vec3> angles;        // by frame of the clip [rad]
  Vec3 rest = Vec3::Zero();        // angles at rest [rad]
  std::optional<BodyHinges> body;  // the hinges, if they are those of a part of a body

  std::string HingeName(int hinge) const;
  Mat3 RotationAt(const Vec3& turned) const;  // in the parent's frame, at such angles
};

struct FigurePlan {
  bool has_clip = false;
  std::vector<PlannedJoint> joints;  // by kept bone; the first one is the root
  std::vector<Vec3> root_position;   // by frame [m]
  std::vector<Vec3> root_angles;     // by frame, z, y, x [rad]
};

// Without a clip there is one frame: at rest. What moves a bone in its parent is dropped, with a
// warning that names it and its range.
FigurePlan PlanFigure(const Character& character, const Skeleton& skeleton, const Clip* clip,
                      const WorldFrame& world, const ImportOptions& options, ImportReport* report);

// The bodies at a frame, in the world [m], by kept bone.
std::vector<Pose> BodiesOf(const FigurePlan& plan, int frame);

// The same at rest, with the root at the origin.
std::vector<Pose> RestBodies(const FigurePlan& plan);

// Where each joint is at a frame [m], by kept bone.
std::vector<Vec3> PositionsOf(const FigurePlan& plan, int frame);

// The same of the file's own bones, with all that moves them.
std::vector<Vec3> FilePositions(const Character& character, const Skeleton& skeleton,
                                const Clip* clip, const WorldFrame& world, int frame);

}  // namespace hazumi
