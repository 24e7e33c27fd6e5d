#include <cmath>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

// A body's mass is shared by its links, which stand for it together: each has its centre of mass
// and as large a share of its inertia.
std::vector<LinkSpec> LinksOf(const BoneBody& body, double length, double density) {
  std::vector<LinkSpec> links;
  const double share = 1.0 / static_cast<double>(body.capsules.size());
  for (const BoneBody::Capsule& capsule : body.capsules) {
    LinkSpec link;
    link.name = capsule.name;
    link.from = length * capsule.from;
    link.to = length * capsule.to;
    link.radius = length * capsule.radius;
    link.mass = share * density * std::pow(length, 3) * body.mass;
    link.com = length * body.com;
    link.inertia = share * density * std::pow(length, 5) * body.inertia;
    links.push_back(std::move(link));
  }
  return links;
}

}  // namespace

std::optional<std::vector<std::vector<LinkSpec>>> KnownLinks(const Character& character,
                                                             const Skeleton& skeleton,
                                                             const WorldFrame& world,
                                                             std::optional<double> mass) {
  if (world.up != UpAxis::kY) return std::nullopt;  // as they were written
  double total = 0.0;
  for (const KeptBone& kept : skeleton.bones) {
    const std::optional<BoneBody>& body = character.bones[kept.bone].body;
    if (!body || body->capsules.empty()) return std::nullopt;
    total += std::pow(world.metres, 3) * body->mass;
  }
  std::vector<std::vector<LinkSpec>> links;
  for (const KeptBone& kept : skeleton.bones) {
    links.push_back(
        LinksOf(*character.bones[kept.bone].body, world.metres, mass.value_or(total) / total));
  }
  return links;
}

}  // namespace hazumi
