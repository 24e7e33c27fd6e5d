#include "engine/placement/contact.h"

#include <algorithm>
#include <limits>

#include "engine/collision/distance.h"

namespace hazumi {

Capsule InWorld(const Link& link, const DynamicsWorkspace& ws, const Vec3& shift) {
  const BodyScratch& body = ws.body(link.joint);
  const Vec3 p = body.p + shift;
  return {p + body.R * link.capsule.a, p + body.R * link.capsule.b, link.capsule.radius};
}

std::optional<Contact> NearestContact(const Figure& figure, const std::vector<SceneObject>& scene,
                                      const DynamicsWorkspace& ws, const Vec3& shift,
                                      const CountsContact& counts) {
  std::optional<Contact> nearest;
  for (size_t link = 0; link < figure.links().size(); ++link) {
    const Capsule capsule = InWorld(figure.links()[link], ws, shift);
    for (size_t object = 0; object < scene.size(); ++object) {
      if (counts && !counts(static_cast<int>(link), static_cast<int>(object))) continue;
      const Distance distance = SignedDistance(capsule, scene[object].shape);
      if (nearest && nearest->clearance <= distance.value) continue;
      nearest = Contact{distance.value, distance.point_on_capsule, distance.normal,
                        static_cast<int>(link), static_cast<int>(object)};
    }
  }
  return nearest;
}

double Clearance(const Figure& figure, const std::vector<SceneObject>& scene,
                 const DynamicsWorkspace& ws, const Vec3& shift) {
  const std::optional<Contact> contact = NearestContact(figure, scene, ws, shift);
  return contact ? contact->clearance : std::numeric_limits<double>::infinity();
}

std::optional<double> FirstTouchOfFigure(const Figure& figure,
                                         const std::vector<SceneObject>& scene,
                                         const DynamicsWorkspace& ws, const Vec3& shift,
                                         const Vec3& translation) {
  std::optional<double> first;
  for (const Link& link : figure.links()) {
    const Capsule capsule = InWorld(link, ws, shift);
    for (const SceneObject& object : scene) {
      const std::optional<double> touch = FirstTouch(capsule, translation, object.shape);
      if (touch && (!first || *touch < *first)) first = touch;
    }
  }
  return first;
}

GroupIndex NearestGroup(const Figure& figure, const DynamicsWorkspace& ws, const Vec3& point) {
  GroupIndex nearest(0);
  double least = std::numeric_limits<double>::infinity();
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    const double distance = (ws.body(figure.groups()[g].first).p - point).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = GroupIndex(g);
  }
  return nearest;
}

}  // namespace hazumi
