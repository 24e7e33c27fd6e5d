#pragma once

// A figure as a person writes it: the input of BuildFigure. Metres, kilograms, radians.

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/body_role.h"
#include "engine/figure/link_surface.h"
#include "engine/figure/strength.h"
#include "engine/spatial/types.h"

namespace hazumi {

// One drawn shape of a link, in the joint's frame. Drawing only; no effect on motion or contact.
struct Look {
  enum class Shape { kTaperedCapsule, kEllipsoid };
  Shape shape = Shape::kTaperedCapsule;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // tapered capsule
  double radius_from = 0.0, radius_to = 0.0;    // tapered capsule
  Vec3 center = Vec3::Zero();                   // ellipsoid
  Vec3 half_axes = Vec3::Zero();                // ellipsoid, along the joint frame's axes
  std::string color;                            // "#rrggbb", sRGB
  std::string mirror_color;                     // of the mirrored twin; empty: the same
};

// A rigid piece carried by a joint: a collision capsule with mass. Several may share a joint.
struct LinkSpec {
  std::string name;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // capsule segment in the joint's frame [m]
  double radius = 0.0;                          // [m]
  std::optional<double> mass;                   // [kg]; exactly one of mass and density
  std::optional<double> density;                // [kg/m^3] of the cylinder between from and to
  std::optional<Vec3> com;                      // default: the middle of the capsule
  std::optional<Mat3> inertia;                  // about the CoM [kg m^2]; default: solid cylinder
  std::vector<Look> looks;                      // default: the capsule itself
  std::optional<LinkSurface> surface;           // in the joint's frame; default: air flows round it
};

struct HingeSpec {
  std::string name;  // may be empty for a joint of one hinge
  Vec3 axis = Vec3::UnitY();
  double lower = 0.0, upper = 0.0;  // [rad]; equal limits: the hinge is fixed there
  double rest = 0.0;                // [rad]
  std::optional<JointStrength> strength = {};
};

// One to three concentric hinges. The first is next to the parent; the links hang on the last.
struct JointSpec {
  std::string name;
  std::string parent;                   // a joint's name, or the root's
  Vec3 offset = Vec3::Zero();           // in the parent's frame [m]
  Mat3 orientation = Mat3::Identity();  // of the joint's frame in the parent's, all angles zero
  std::vector<HingeSpec> hinges;
  std::vector<LinkSpec> links;
  std::optional<BodyPlace> body = {};  // not given: told by its name, if no joint states it

  // What a hinge is called in the figure.
  std::string NameOf(const HingeSpec& hinge) const {
    return hinge.name.empty() ? name : name + "_" + hinge.name;
  }
};

// Joints whose name begins with `from` get a twin, reflected through the plane y = 0, whose name
// begins with `to`. Equal angles on both sides are mirror-image poses.
struct MirrorSpec {
  std::string from, to;
};

struct FigureSpec {
  std::string name;
  std::string root_name;
  std::vector<LinkSpec> root_links;
  std::vector<JointSpec> joints;  // any order; parents need not come first
  std::optional<MirrorSpec> mirror;
};

}  // namespace hazumi
