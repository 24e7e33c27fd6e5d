#include "engine/figure/sides.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

using Groups = std::vector<GroupIndex>;

// The body that a joint hangs on, as an index of a joint plus one; 0: the root.
size_t ParentOf(const Figure& figure, size_t group) {
  const JointIndex parent = figure.joint(figure.groups()[group].first).parent;
  return parent.is_valid() ? static_cast<size_t>(figure.joint(parent).group.value()) + 1 : 0;
}

// As its place in the body states, or else its name.
BodySide SideSaidOf(const JointGroup& joint) {
  const bool is_stated = joint.body && joint.body->side != BodySide::kMiddle;
  return is_stated ? joint.body->side : SideNamed(joint.name);
}

class Pairing {
 public:
  explicit Pairing(const Figure& figure)
      : figure_(figure), children_(figure.groups().size() + 1), other_(figure.groups().size()) {
    for (size_t g = 0; g < other_.size(); ++g) {
      other_[g] = GroupIndex(static_cast<int>(g));
      named_[figure.groups()[g].name] = other_[g];
      children_[ParentOf(figure, g)].push_back(other_[g]);
    }
  }

  // Parents come before their children: those of a pair are paired when its first one comes.
  Groups Pair() {
    PairChildren(0, 0);
    for (size_t g = 0; g < other_.size(); ++g) {
      const auto other = static_cast<size_t>(other_[g].value());
      if (g <= other) PairChildren(g + 1, other + 1);
    }
    return std::move(other_);
  }

 private:
  const std::string& name(GroupIndex g) const { return figure_.group(g).name; }
  bool IsAlone(GroupIndex g) const { return other_[g.value()] == g; }

  void PairChildren(size_t parent, size_t other_parent) {
    for (const GroupIndex g : children_[parent]) PairByRole(g, other_parent);
    for (const GroupIndex g : children_[parent]) PairByName(g, other_parent);
    const Groups here = Alone(parent), there = Alone(other_parent);
    if (parent != other_parent) {
      if (here.size() == 1 && there.size() == 1) Join(here[0], there[0]);
      return;
    }
    const Groups left = On(BodySide::kLeft, here), right = On(BodySide::kRight, here);
    if (left.size() == 1 && right.size() == 1) Join(left[0], right[0]);
  }

  const std::optional<BodyPlace>& place(GroupIndex g) const { return figure_.group(g).body; }

  // With the only one there that has its role on the other side, if it is the only one here too.
  void PairByRole(GroupIndex g, size_t other_parent) {
    if (!place(g) || place(g)->side == BodySide::kMiddle) return;
    const size_t parent = ParentOf(figure_, static_cast<size_t>(g.value()));
    const Groups here = Having(*place(g), parent);
    const Groups there = Having({place(g)->role, OtherSide(place(g)->side)}, other_parent);
    if (here.size() == 1 && there.size() == 1 && IsAlone(g) && IsAlone(there[0])) Join(g, there[0]);
  }

  Groups Having(const BodyPlace& wanted, size_t parent) const {
    Groups having;
    for (const GroupIndex g : children_[parent]) {
      if (place(g) == wanted) having.push_back(g);
    }
    return having;
  }

  void PairByName(GroupIndex g, size_t other_parent) {
    for (const std::string& candidate : OtherSideNames(name(g))) {
      const auto found = named_.find(candidate);
      if (found == named_.end() || !IsAlone(g) || !IsAlone(found->second)) continue;
      const auto other = static_cast<size_t>(found->second.value());
      if (ParentOf(figure_, other) == other_parent) Join(g, found->second);
    }
  }

  void Join(GroupIndex a, GroupIndex b) {
    other_[a.value()] = b;
    other_[b.value()] = a;
  }

  Groups Alone(size_t parent) const {
    Groups alone;
    for (const GroupIndex g : children_[parent]) {
      if (IsAlone(g)) alone.push_back(g);
    }
    return alone;
  }

  Groups On(BodySide side, const Groups& groups) const {
    Groups on;
    for (const GroupIndex g : groups) {
      if (SideSaidOf(figure_.group(g)) == side) on.push_back(g);
    }
    return on;
  }

  const Figure& figure_;
  std::vector<Groups> children_;  // by parent
  std::unordered_map<std::string, GroupIndex> named_;
  Groups other_;
};

// Of a pair: the side of the first one. "lfemur" and "rfemur" differ in the letter that says it.
BodySide SideOfPair(const JointGroup& joint, const JointGroup& partner) {
  if (const BodySide side = SideSaidOf(joint); side != BodySide::kMiddle) return side;
  if (const BodySide side = SideSaidOf(partner); side != BodySide::kMiddle) return OtherSide(side);
  const std::string &name = joint.name, &other = partner.name;
  const size_t end = std::min(name.size(), other.size());
  const auto differs =
      std::mismatch(name.begin(), name.begin() + static_cast<long>(end), other.begin());
  const bool is_left = differs.first != name.end() &&
                       std::tolower(static_cast<unsigned char>(*differs.first)) == 'l';
  return is_left ? BodySide::kLeft : BodySide::kRight;
}

std::vector<BodySide> SidesOf(const Figure& figure, const Groups& other) {
  std::vector<BodySide> sides(other.size(), BodySide::kMiddle);
  for (size_t g = 0; g < other.size(); ++g) {
    const JointGroup& joint = figure.groups()[g];
    const size_t parent = ParentOf(figure, g);
    const BodySide above = parent == 0 ? BodySide::kMiddle : sides[parent - 1];
    const auto partner = static_cast<size_t>(other[g].value());
    if (partner == g) {
      const BodySide said = SideSaidOf(joint);
      sides[g] = said == BodySide::kMiddle ? above : said;
    } else {
      const bool is_on_pair = ParentOf(figure, partner) != parent;
      sides[g] = is_on_pair ? above : SideOfPair(joint, figure.groups()[partner]);
    }
  }
  return sides;
}

Vec3 NearAxis(const Vec3& direction) {
  const double kAlongAxis = std::cos(10.0 * kDegree);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[i]) >= kAlongAxis) return Vec3::Unit(i);
  }
  return direction;
}

}  // namespace

FigureSides::FigureSides(const Figure& figure)
    : other_(Pairing(figure).Pair()), side_(SidesOf(figure, other_)) {
  const std::vector<Pose> X_RJ = PosesAtZero(figure);
  Vec3 to_left = Vec3::Zero();
  for (size_t g = 0; g < other_.size(); ++g) {
    if (other_[g].value() == static_cast<int>(g) || side_[g] == BodySide::kMiddle) continue;
    const Vec3& p = X_RJ[static_cast<size_t>(figure.groups()[g].first.value())].p;
    to_left += side_[g] == BodySide::kLeft ? p : Vec3(-p);
  }
  constexpr double kTogether = 1e-6;  // [m]: joints that lie in one another tell nothing
  if (to_left.norm() > kTogether) normal_ = NearAxis(to_left.normalized());
}

JointIndex FigureSides::OtherSideOf(JointIndex hinge, const Figure& figure) const {
  const GroupIndex g = figure.joint(hinge).group;
  const JointGroup &own = figure.group(g), &other = figure.group(OtherSideOf(g));
  if (own.first == other.first) return hinge;
  const std::string& name = figure.joint(hinge).name;
  const std::string wanted = other.name + name.substr(std::min(name.size(), own.name.size()));
  for (int j = other.first.value(); j <= other.last().value(); ++j) {
    if (figure.joints()[static_cast<size_t>(j)].name == wanted) return JointIndex(j);
  }
  const int place = hinge.value() - own.first.value();
  return JointIndex(other.first.value() + std::min(place, other.size - 1));
}

std::string FigureSides::OtherSideOf(const std::string& name, const Figure& figure) const {
  if (const auto hinge = figure.FindJoint(name)) {
    return figure.joint(OtherSideOf(*hinge, figure)).name;
  }
  const auto joint = figure.FindGroup(name);
  return joint ? figure.group(OtherSideOf(*joint)).name : name;
}

std::vector<Pose> PosesAtZero(const Figure& figure) {
  std::vector<Pose> X_RJ;
  X_RJ.reserve(figure.joints().size());
  for (const Joint& joint : figure.joints()) {
    const bool on_root = !joint.parent.is_valid();
    X_RJ.push_back(on_root ? joint.X_PJ
                           : X_RJ[static_cast<size_t>(joint.parent.value())] * joint.X_PJ);
  }
  return X_RJ;
}

}  // namespace hazumi
