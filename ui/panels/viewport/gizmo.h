#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::ui {

// A circle about a hinge's axis or an axis of the root, of the same size on the screen wherever it
// is.
struct GizmoRing {
  JointIndex hinge;   // invalid: of the root, or of all selected joints
  Vec3 center, axis;  // world [m]
  double radius;      // [m]
  int color_axis;     // 0 x, 1 y, 2 z: of the root or the world, or what is nearest in its parent's
                      // frame
  Vec3 At(double t) const;  // t: an angle [rad] from anywhere, counter-clockwise about the axis
};

// How far a hinge turns, drawn about its axis.
struct LimitArc {
  JointIndex hinge;
  Vec3 center, axis, limb;         // limb: unit, where it points now, square to the axis
  double radius;                   // [m]
  double angle, lower, upper;      // [rad]
  Vec3 At(double at_angle) const;  // on the arc
};

// What turns joints or the root by the mouse.
struct Gizmo {
  std::vector<GizmoRing> rings;
  std::optional<LimitArc> arc;  // of the active hinge
};

// Of the root if it is selected, or of the one selected joint, about its hinges; of several, about
// the world's axes in their middle. None if nothing that turns is selected. `active`: the hinge
// whose limits are shown if it belongs to the joint; else the first.
std::optional<Gizmo> GizmoOf(const View& view, const edit::Session& session,
                             const PosedFigure& figure, const std::string& active, bool with_limits,
                             double scale);

enum class GizmoPart { kRing, kLower, kUpper };
struct GizmoHit {
  GizmoPart part;
  JointIndex hinge;
  Vec3 at;       // the point of the ring [m]
  int axis = 0;  // of the root or the world
};
// What is under a point: the ends of the arc go before rings, near halves before far ones.
std::optional<GizmoHit> GizmoAt(const View& view, Point at, const Gizmo& gizmo, double scale);

// The angle [rad] at which the limb would point to where the mouse is, the one nearest to `near`;
// none if the arc is seen from its edge.
std::optional<double> AngleAt(const View& view, Point at, const LimitArc& arc, double near);

}  // namespace hazumi::ui
