#include "engine/figure/figure_builder.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hazumi {

namespace {

std::string At(const std::string& list, size_t i) { return list + "[" + std::to_string(i) + "]"; }

Error Wrong(std::string place, std::string message) {
  return {ErrorCode::kSchema, "", std::move(place), std::move(message)};
}

double MassOf(const LinkSpec& link) {
  if (link.mass) return *link.mass;
  const double length = (link.to - link.from).norm();
  return *link.density * std::numbers::pi * link.radius * link.radius * length;
}

RigidInertia InertiaOf(const LinkSpec& link) {
  RigidInertia body = SolidCylinder(link.from, link.to, link.radius, MassOf(link));
  if (link.com) body.com = *link.com;
  if (link.inertia) body.I_com = *link.inertia;
  return body;
}

// A real body's principal moments are positive and none exceeds the sum of the others.
bool IsPhysical(const Mat3& inertia) {
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvalues();
  // A thin rod's smallest moment is zero but for rounding.
  return moments[0] >= -1e-9 * moments[2] && moments[2] <= (moments[0] + moments[1]) * (1.0 + 1e-9);
}

std::optional<Error> CheckLink(const LinkSpec& link, const std::string& place) {
  if (link.mass.has_value() == link.density.has_value()) {
    return Wrong(place, "needs exactly one of mass and density");
  }
  if (link.inertia && !IsPhysical(*link.inertia)) {
    return Wrong(place + ".inertia_kg_m2",
                 "no body has these moments: each must be positive and at most the sum of the "
                 "other two");
  }
  return std::nullopt;
}

std::optional<Error> CheckLinks(const std::vector<LinkSpec>& links, const std::string& place) {
  for (size_t i = 0; i < links.size(); ++i) {
    if (auto error = CheckLink(links[i], At(place + ".links", i))) return error;
  }
  return std::nullopt;
}

std::optional<Error> CheckHinge(const HingeSpec& hinge, const std::string& place) {
  if (hinge.axis.norm() < 1e-9) return Wrong(place + ".axis", "must not be zero");
  if (hinge.lower > hinge.upper) {
    return Wrong(place + ".limits_deg", "the lower limit is above the upper one");
  }
  return std::nullopt;
}

std::optional<Error> CheckJoint(const JointSpec& joint, const std::string& place) {
  if (joint.hinges.empty() || joint.hinges.size() > 3) {
    return Wrong(place + ".hinges", "a joint has one to three hinges");
  }
  for (size_t h = 0; h < joint.hinges.size(); ++h) {
    if (auto error = CheckHinge(joint.hinges[h], At(place + ".hinges", h))) return error;
  }
  return CheckLinks(joint.links, place);
}

}  // namespace

// Turns a specification with its twins into a Figure, depth first from the root.
class FigureAssembler {
 public:
  explicit FigureAssembler(const FigureSpec& spec) : spec_(spec) {}

  Result<Figure> Assemble() {
    if (auto error = Check()) return *error;
    figure_.name_ = spec_.name;
    figure_.root_name_ = spec_.root_name;
    figure_.root_body_ = AddLinks(spec_.root_links, JointIndex());
    AddJoints();
    IndexNames();
    if (auto error = CheckAllReached()) return *error;
    figure_.total_mass_ = figure_.root_body_.mass;
    for (const RigidInertia& body : figure_.bodies_) figure_.total_mass_ += body.mass;
    if (figure_.total_mass_ <= 0.0) return Wrong("", "the figure has no mass");
    return std::move(figure_);
  }

 private:
  std::optional<Error> Check() {
    if (auto error = CheckLinks(spec_.root_links, "root")) return error;
    names_[spec_.root_name] = "root";
    for (size_t i = 0; i < spec_.joints.size(); ++i) {
      const std::string place = At("joints", i);
      if (auto error = CheckJoint(spec_.joints[i], place)) return error;
      if (auto error = ClaimNames(spec_.joints[i], place)) return error;
    }
    return CheckParents();
  }

  // A group and its hinges share one name space; a lone unnamed hinge is called as its group.
  std::optional<Error> ClaimNames(const JointSpec& joint, const std::string& place) {
    if (auto error = ClaimName(joint.name, place)) return error;
    for (const HingeSpec& hinge : joint.hinges) {
      if (hinge.name.empty() && joint.hinges.size() == 1) continue;
      if (auto error = ClaimName(joint.NameOf(hinge), place)) return error;
    }
    return std::nullopt;
  }

  std::optional<Error> ClaimName(const std::string& name, const std::string& place) {
    const auto [it, fresh] = names_.emplace(name, place);
    if (fresh) return std::nullopt;
    return Wrong(place, "the name \"" + name + "\" is already used by " + it->second);
  }

  std::optional<Error> CheckParents() {
    children_[spec_.root_name];
    for (const JointSpec& joint : spec_.joints) children_[joint.name];
    for (size_t i = 0; i < spec_.joints.size(); ++i) {
      const auto siblings = children_.find(spec_.joints[i].parent);
      if (siblings == children_.end()) {
        return Wrong(At("joints", i) + ".parent", "no joint \"" + spec_.joints[i].parent + "\"");
      }
      siblings->second.push_back(&spec_.joints[i]);
    }
    return std::nullopt;
  }

  // Every joint has a known parent, so one that was not reached hangs on a loop.
  std::optional<Error> CheckAllReached() {
    if (figure_.groups_.size() == spec_.joints.size()) return std::nullopt;
    for (size_t i = 0; i < spec_.joints.size(); ++i) {
      if (figure_.FindGroup(spec_.joints[i].name)) continue;
      return Wrong(At("joints", i) + ".parent",
                   "\"" + spec_.joints[i].name + "\" is its own ancestor: the parents form a loop");
    }
    return std::nullopt;
  }

  // Depth first, without recursion: chains may be long.
  void AddJoints() {
    struct Waiting {
      const JointSpec* spec;
      JointIndex parent;
    };
    std::vector<Waiting> waiting;
    const auto await_children = [&](const std::string& name, JointIndex parent) {
      const auto& children = children_[name];
      for (auto it = children.rbegin(); it != children.rend(); ++it) {
        waiting.push_back({*it, parent});
      }
    };
    await_children(spec_.root_name, JointIndex());
    while (!waiting.empty()) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      await_children(next.spec->name, AddJoint(*next.spec, next.parent));
    }
    EndSubtrees();
  }

  // Returns its last hinge.
  JointIndex AddJoint(const JointSpec& spec, JointIndex parent) {
    const GroupIndex group(static_cast<int>(figure_.groups_.size()));
    const JointIndex first(figure_.num_joints());
    figure_.groups_.push_back({spec.name, first, static_cast<int>(spec.hinges.size()), spec.body});
    Pose X_PJ{spec.orientation, spec.offset};
    for (const HingeSpec& hinge : spec.hinges) {
      AddHinge(spec, hinge, group, parent, X_PJ);
      parent = JointIndex(figure_.num_joints() - 1);
      X_PJ = Pose();
    }
    figure_.bodies_[parent.value()] = AddLinks(spec.links, parent);
    figure_.joints_[parent.value()].massless = figure_.bodies_[parent.value()].is_massless();
    return parent;
  }

  // A subtree ends where the last one of its children does.
  void EndSubtrees() {
    std::vector<Joint>& joints = figure_.joints_;
    for (int j = figure_.num_joints() - 1; j >= 0; --j) {
      if (!joints[j].subtree_end.is_valid()) joints[j].subtree_end = JointIndex(j + 1);
      if (!joints[j].parent.is_valid()) continue;
      JointIndex& end = joints[joints[j].parent.value()].subtree_end;
      end = std::max(end, joints[j].subtree_end);
    }
  }

  void IndexNames() {
    auto index = std::make_shared<Figure::NameIndex>();
    for (int j = 0; j < figure_.num_joints(); ++j) {
      index->joints.emplace(figure_.joints_[j].name, j);
    }
    for (size_t g = 0; g < figure_.groups_.size(); ++g) {
      index->groups.emplace(figure_.groups_[g].name, static_cast<int>(g));
    }
    figure_.index_ = std::move(index);
  }

  void AddHinge(const JointSpec& spec, const HingeSpec& hinge, GroupIndex group, JointIndex parent,
                const Pose& X_PJ) {
    Joint joint;
    joint.name = spec.NameOf(hinge);
    joint.parent = parent;
    joint.group = group;
    joint.X_PJ = X_PJ;
    joint.axis = hinge.axis.normalized();
    joint.lower = hinge.lower;
    joint.upper = hinge.upper;
    joint.rest = hinge.lower == hinge.upper ? hinge.lower : hinge.rest;  // fixed hinges stay put
    joint.parallel_frame = X_PJ.R.isIdentity(0.0);
    joint.massless = true;
    joint.strength = hinge.strength;
    figure_.joints_.push_back(joint);
    figure_.bodies_.push_back({});
  }

  RigidInertia AddLinks(const std::vector<LinkSpec>& links, JointIndex joint) {
    RigidInertia body;
    for (const LinkSpec& link : links) {
      figure_.links_.push_back(
          {link.name, joint, {link.from, link.to, link.radius}, link.looks, link.surface});
      body = Combine(body, InertiaOf(link));
    }
    return body;
  }

  const FigureSpec& spec_;
  std::map<std::string, std::string> names_;                       // name -> where it was given
  std::map<std::string, std::vector<const JointSpec*>> children_;  // by the parent's name
  Figure figure_;
};

Result<Figure> BuildFigure(const FigureSpec& spec) {
  const FigureSpec both = WithMirroredTwins(spec);
  return FigureAssembler(both).Assemble();
}

}  // namespace hazumi
