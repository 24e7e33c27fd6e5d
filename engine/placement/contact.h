#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// The figure counts as touching when its clearance is at most this [m]. [METHOD 5.4]
inline constexpr double kTouching = 1e-6;

// The place where the figure is nearest to, or deepest in, anything of the scene.
struct Contact {
  double clearance = 0.0;      // signed distance [m]
  Vec3 point = Vec3::Zero();   // on the figure's surface, world [m]
  Vec3 normal = Vec3::Zero();  // unit, from the obstacle to the figure
  int link = 0, object = 0;    // indices of Figure::links and the scene
};

// All of these need ComputePositions and see the figure moved by `shift` [m].

// What touches things of a link, in the world.
Capsule InWorld(const Link& link, const DynamicsWorkspace& ws, const Vec3& shift = Vec3::Zero());

// Whether a link, and an object of the scene, by index, are a pair to look at; null: all are.
using CountsContact = std::function<bool(int link, int object)>;

// No contact if the scene or the figure has no shapes.
std::optional<Contact> NearestContact(const Figure& figure, const std::vector<SceneObject>& scene,
                                      const DynamicsWorkspace& ws, const Vec3& shift = Vec3::Zero(),
                                      const CountsContact& counts = {});

// Its signed distance [m], infinite without one.
double Clearance(const Figure& figure, const std::vector<SceneObject>& scene,
                 const DynamicsWorkspace& ws, const Vec3& shift = Vec3::Zero());

// The least fraction of `translation` after which the figure touches something; none if it passes
// freely. To 1e-9 m.
std::optional<double> FirstTouchOfFigure(const Figure& figure,
                                         const std::vector<SceneObject>& scene,
                                         const DynamicsWorkspace& ws, const Vec3& shift,
                                         const Vec3& translation);

// The joint whose origin is nearest to `point`. [Arai 3.2 (6)]
GroupIndex NearestGroup(const Figure& figure, const DynamicsWorkspace& ws, const Vec3& point);

}  // namespace hazumi
