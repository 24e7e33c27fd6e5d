#pragma once

// Internal. From the axes and the unit of a file to Hazumi's: z up, x forward, y left, metres.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "engine/body/body_axes.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/import/skeleton.h"

namespace hazumi {

struct WorldFrame {
  UpAxis up = UpAxis::kY;
  Mat3 C = Mat3::Identity();  // of the file's axes in the world's, but for F
  Mat3 F = Mat3::Identity();  // about z: turns the figure so that it faces x at rest
  double metres = 1.0;        // per unit
  double height = 0.0;        // of the figure at rest [m]

  // A turn of one bone from another; a turn in the world; a bone's axes in the world.
  Mat3 Turned(const Mat3& R) const { return C * R * C.transpose(); }
  Mat3 TurnedInWorld(const Mat3& R) const { return F * Turned(R) * F.transpose(); }
  Mat3 AxesInWorld(const Mat3& R) const { return F * Turned(R); }
  // A way in a bone's axes, and in the world's [m].
  Vec3 Way(const Vec3& p) const { return metres * (C * p); }
  Vec3 Placed(const Vec3& p) const { return F * Way(p); }
};

// A file's z goes forward where y is up (x is left); where z is up, x goes forward.
Mat3 AxesOf(UpAxis up);

// What neither the options nor the file say is guessed from the skeleton: along which axis it is
// tall, standing in the clip or at rest, and which unit makes it as tall as a person. What was
// decided, and why, is added to `report`.
WorldFrame WorldFrameOf(const Character& character, const Skeleton& skeleton, const Clip* clip,
                        const ImportOptions& options, ImportReport* report);

// The kept bones where they are at rest, in the world's axes [m].
std::vector<RestBone> RestBonesOf(const Skeleton& skeleton, const WorldFrame& world);

// Turns the figure so that it faces x: exactly, or by right angles if it faces nearly along an
// axis.
void FaceForward(const Skeleton& skeleton, ImportReport* report, WorldFrame* world);

}  // namespace hazumi
