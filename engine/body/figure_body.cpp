#include "engine/body/figure_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/body/bone_roles.h"
#include "engine/figure/sides.h"

namespace hazumi {

namespace {

// A joint of the human that comes with Hazumi: the part [begin, end] of a row of joints.
struct HumanJoint {
  const char* name;
  BodyRole role;
  bool has_sides;
  double begin, end;
  std::array<const char*, 3> motions;
};

constexpr HumanJoint kHumanJoints[] = {
    {"waist", BodyRole::kSpine, false, 0.0, 0.5, {"flexion", "bend", "rotation"}},
    {"chest", BodyRole::kSpine, false, 0.5, 1.0, {"flexion", "bend", "rotation"}},
    {"neck", BodyRole::kNeck, false, 0.0, 1.0, {"flexion", "bend", "rotation"}},
    {"shoulder", BodyRole::kUpperArm, true, 0.0, 1.0, {"flexion", "rotation", "abduction"}},
    {"elbow", BodyRole::kForearm, true, 0.0, 1.0, {"flexion", "pronation", nullptr}},
    {"wrist", BodyRole::kHand, true, 0.0, 1.0, {"flexion", "deviation", nullptr}},
    {"hip", BodyRole::kThigh, true, 0.0, 1.0, {"flexion", "abduction", "rotation"}},
    {"knee", BodyRole::kShin, true, 0.0, 1.0, {"", nullptr, nullptr}},
    {"ankle", BodyRole::kFoot, true, 0.0, 1.0, {"flexion", "inversion", nullptr}},
    {"toe", BodyRole::kToe, true, 0.0, 1.0, {"", nullptr, nullptr}}};

struct ReadHinge {
  const HumanJoint* joint = nullptr;
  BodySide side = BodySide::kMiddle;
  std::string motion;
};

std::string NameOf(const HumanJoint& joint, const char* motion) {
  return joint.name + std::string(*motion ? "_" : "") + motion;
}

// Names of all hinges of the human.
std::vector<std::string> HumanHinges() {
  std::vector<std::string> names;
  for (const HumanJoint& joint : kHumanJoints) {
    for (const char* motion : joint.motions) {
      if (!motion) continue;
      if (!joint.has_sides) names.push_back(NameOf(joint, motion));
      for (const char* side : {"r_", "l_"}) {
        if (joint.has_sides) names.push_back(side + NameOf(joint, motion));
      }
    }
  }
  return names;
}

std::optional<ReadHinge> ReadHumanHinge(std::string name) {
  ReadHinge read;
  if (name.starts_with("r_") || name.starts_with("l_")) {
    read.side = name[0] == 'r' ? BodySide::kRight : BodySide::kLeft;
    name.erase(0, 2);
  }
  for (const HumanJoint& joint : kHumanJoints) {
    if (joint.has_sides != (read.side != BodySide::kMiddle)) continue;
    for (const char* motion : joint.motions) {
      if (!motion || name != NameOf(joint, motion)) continue;
      read.joint = &joint;
      read.motion = *motion ? motion : "flexion";
      return read;
    }
  }
  return std::nullopt;
}

// A joint of a row that does a part of what a joint of the human does: the share of the human's
// angle that it does, and the share of its own angle that is the human's.
struct Covering {
  GroupIndex joint;
  double of_human = 0.0, of_own = 0.0;
};

std::vector<Covering> CoveringOf(const HumanJoint& human, const std::vector<GroupIndex>& row) {
  constexpr double kNothing = 1e-9;
  std::vector<Covering> covering;
  const double length = 1.0 / static_cast<double>(row.size());
  for (size_t i = 0; i < row.size(); ++i) {
    const double at = static_cast<double>(i) * length;
    const double both = std::min(at + length, human.end) - std::max(at, human.begin);
    if (both <= kNothing) continue;
    covering.push_back({row[i], both / (human.end - human.begin), both / length});
  }
  return covering;
}

std::vector<BodyPlace> PlacesOf(const Figure& figure) {
  std::vector<BodyPlace> places;
  bool is_stated = false;
  for (const JointGroup& joint : figure.groups()) {
    is_stated = is_stated || joint.body.has_value();
    places.push_back(joint.body.value_or(BodyPlace()));
  }
  if (is_stated) return places;
  std::vector<NamedBone> bones = {{figure.root_name(), -1}};
  for (const JointGroup& joint : figure.groups()) {
    const JointIndex parent = figure.joint(joint.first).parent;
    bones.push_back({joint.name, parent.is_valid() ? figure.joint(parent).group.value() + 1 : 0});
  }
  places = RolesByName(bones).places;
  places.erase(places.begin());
  return places;
}

}  // namespace

FigureBody::FigureBody(const Figure& figure) : figure_(figure), places_(PlacesOf(figure)) {}

bool FigureBody::HasFourLegs() const {
  const std::vector<Pose> X_RJ = PosesAtZero(figure_);
  Vec3 trunk = Vec3::Zero();
  for (size_t g = 0; g < places_.size(); ++g) {
    if (places_[g].role != BodyRole::kUpperArm) continue;
    trunk += X_RJ[static_cast<size_t>(figure_.groups()[g].first.value())].p;
  }
  return trunk.head<2>().norm() > std::abs(trunk.z());
}

std::vector<GroupIndex> FigureBody::All(BodyRole role, BodySide side) const {
  std::vector<GroupIndex> all;
  for (size_t g = 0; g < places_.size(); ++g) {
    if (places_[g] == BodyPlace{role, side}) all.emplace_back(static_cast<int>(g));
  }
  return all;
}

std::optional<GroupIndex> FigureBody::Find(BodyRole role, BodySide side) const {
  const std::vector<GroupIndex> all = All(role, side);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

// Joints that do together what one joint of the human, or its row, does: a neck with its head.
std::vector<GroupIndex> FigureBody::Row(BodyRole role, BodySide side) const {
  if (role == BodyRole::kSpine) return All(role, side);
  if (role == BodyRole::kNeck) {
    std::vector<GroupIndex> row = All(role, side);
    for (const GroupIndex head : All(BodyRole::kHead, side)) row.push_back(head);
    return row;
  }
  const std::optional<GroupIndex> one = Find(role, side);
  return one ? std::vector<GroupIndex>{*one} : std::vector<GroupIndex>();
}

std::optional<JointIndex> FigureBody::HingeNamed(GroupIndex joint,
                                                 const std::string& motion) const {
  const JointGroup& group = figure_.group(joint);
  const std::string name = group.name + "_" + motion;
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    const Joint& hinge = figure_.joint(JointIndex(j));
    const bool is_it = hinge.name == name || (group.size == 1 && motion == "flexion");
    if (is_it && !hinge.is_fixed()) return JointIndex(j);
  }
  return std::nullopt;
}

std::vector<HingeShare> FigureBody::HingesFor(const std::string& human_hinge) const {
  const std::optional<ReadHinge> read = ReadHumanHinge(human_hinge);
  if (!read) return {};
  std::vector<HingeShare> shares;
  const std::vector<GroupIndex> row = Row(read->joint->role, read->side);
  for (const Covering& part : CoveringOf(*read->joint, row)) {
    const std::optional<JointIndex> hinge = HingeNamed(part.joint, read->motion);
    if (hinge) shares.push_back({*hinge, part.of_human});
  }
  return shares;
}

std::optional<JointIndex> FigureBody::HingeFor(const std::string& human_hinge) const {
  const std::vector<HingeShare> shares = HingesFor(human_hinge);
  return shares.size() == 1 ? std::optional(shares[0].hinge) : std::nullopt;
}

std::vector<std::pair<std::string, double>> FigureBody::HumanAngles(const VecX& q) const {
  std::vector<std::pair<std::string, double>> angles;
  for (const std::string& name : HumanHinges()) {
    const ReadHinge read = *ReadHumanHinge(name);
    double angle = 0.0;
    bool is_there = false;
    for (const Covering& part : CoveringOf(*read.joint, Row(read.joint->role, read.side))) {
      const std::optional<JointIndex> hinge = HingeNamed(part.joint, read.motion);
      if (!hinge) continue;
      angle += part.of_own * q[hinge->value()];
      is_there = true;
    }
    if (is_there) angles.emplace_back(name, angle);
  }
  return angles;
}

double StandingHeight(const Figure& figure) {
  const std::vector<Pose> X_RJ = PosesAtZero(figure);
  double lowest = 0.0;
  for (const Link& link : figure.links()) {
    const Pose X_RL =
        link.joint.is_valid() ? X_RJ[static_cast<size_t>(link.joint.value())] : Pose();
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      lowest = std::min(lowest, (X_RL * end).z() - link.capsule.radius);
    }
  }
  return -lowest;
}

}  // namespace hazumi
