#include "engine/figure/figure_builder.h"

// Reflection through the plane y = 0, S = diag(1, -1, 1). A turn by t about axis a becomes a turn
// by -t about S a, that is by t about -S a: equal angles are mirror-image poses.

namespace hazumi {

namespace {

const Vec3 kReflect(1.0, -1.0, 1.0);

Vec3 Reflect(const Vec3& point) { return kReflect.cwiseProduct(point); }
Mat3 Reflect(const Mat3& tensor) { return kReflect.asDiagonal() * tensor * kReflect.asDiagonal(); }

std::string TwinName(const std::string& name, const MirrorSpec& mirror) {
  return name.starts_with(mirror.from) ? mirror.to + name.substr(mirror.from.size()) : name;
}

Look Twin(Look look) {
  look.from = Reflect(look.from);
  look.to = Reflect(look.to);
  look.center = Reflect(look.center);
  if (!look.mirror_color.empty()) look.color = look.mirror_color;
  return look;
}

LinkSpec Twin(LinkSpec link, const MirrorSpec& mirror) {
  link.name = TwinName(link.name, mirror);
  link.from = Reflect(link.from);
  link.to = Reflect(link.to);
  if (link.com) link.com = Reflect(*link.com);
  if (link.inertia) link.inertia = Reflect(*link.inertia);
  for (Look& look : link.looks) look = Twin(look);
  if (link.surface) {
    link.surface->normal = Reflect(link.surface->normal);
    link.surface->center = Reflect(link.surface->center);
  }
  return link;
}

JointSpec Twin(JointSpec joint, const MirrorSpec& mirror) {
  joint.name = TwinName(joint.name, mirror);
  joint.parent = TwinName(joint.parent, mirror);
  joint.offset = Reflect(joint.offset);
  joint.orientation = Reflect(joint.orientation);
  if (joint.body) joint.body->side = OtherSide(joint.body->side);
  for (HingeSpec& hinge : joint.hinges) hinge.axis = -Reflect(hinge.axis);
  for (LinkSpec& link : joint.links) link = Twin(link, mirror);
  return joint;
}

}  // namespace

FigureSpec WithMirroredTwins(const FigureSpec& spec) {
  if (!spec.mirror) return spec;
  FigureSpec both = spec;
  for (const JointSpec& joint : spec.joints) {
    if (joint.name.starts_with(spec.mirror->from)) both.joints.push_back(Twin(joint, *spec.mirror));
  }
  return both;
}

}  // namespace hazumi
