#include "engine/region/region_model.h"

#include <algorithm>
#include <cmath>

#include "engine/region/hinge_triple.h"

namespace hazumi {

namespace {

// Where the frame of a joint sits: fixed to a node, beyond so many of its hinges.
struct Seat {
  int node = 0;
  Pose X_NJ;
  int num_hinges = 0;
};

NodeHinge HingeAbout(const Vec3& axis, Coordinate coordinate) {
  for (int i = 0; i < 3; ++i) {
    for (const double sign : {1.0, -1.0}) {
      if (axis == sign * Vec3::Unit(i)) return {coordinate, axis, i, sign};
    }
  }
  return {coordinate, axis, 3, 1.0};
}

// The whole figure as one model.
class ModelCompiler {
 public:
  ModelCompiler(const Figure& figure, const ModelRequest& request)
      : figure_(figure), request_(request), seats_(figure.num_joints()) {}

  RegionModel Compile() {
    AddRoot();
    for (int j = 0; j < figure_.num_joints(); ++j) AddJoint(JointIndex(j));
    for (ModelNode& node : model_.nodes) FinishNode(&node);
    model_.coupling = request_.coupling;
    if (request_.coupling == RootCoupling::kPinned) {
      const Seat seat = SeatBefore(request_.pin);
      model_.pin_node = seat.node;
      model_.p_pin = seat.X_NJ.p;
    }
    if (request_.lists_joints) ListJoints();
    return std::move(model_);
  }

 private:
  void AddRoot() {
    const Vec3 axes[kRootAngles] = {Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()};
    ModelNode root;
    root.role = request_.roles[figure_.num_joints()];
    for (int i = 0; i < kRootAngles; ++i) {
      const Coordinate c = figure_.num_joints() + i;
      if (root.role == Role::kConstant) {
        const double q = request_.angles[c];
        model_.R_root = model_.R_root * AxisRotation<double>(axes[i], std::sin(q), std::cos(q));
      } else {
        root.hinges[root.num_hinges++] = HingeAbout(axes[i], c);
      }
    }
    root.body = figure_.root_body();
    model_.nodes.push_back(root);
  }

  void ListJoints() {
    model_.joints.push_back({JointIndex(), 0, Vec3::Zero(), Mat3::Identity()});
    for (int j = 0; j < figure_.num_joints(); ++j) {
      const Seat& seat = seats_[j];
      // A hinge of the node turns beyond it: what it carries is massless.
      if (seat.num_hinges < model_.nodes[seat.node].num_hinges) continue;
      model_.joints.push_back({JointIndex(j), seat.node, seat.X_NJ.p, seat.X_NJ.R});
    }
    std::stable_sort(model_.joints.begin(), model_.joints.end(),
                     [](const NodeJoint& a, const NodeJoint& b) { return a.node < b.node; });
  }

  // The frame of joint j, before it turns.
  Seat SeatBefore(JointIndex j) const {
    const Joint& joint = figure_.joint(j);
    const Seat parent = joint.parent.is_valid() ? seats_[joint.parent.value()] : Seat();
    return {parent.node, parent.X_NJ * joint.X_PJ, parent.num_hinges};
  }

  void AddJoint(JointIndex j) {
    const Joint& joint = figure_.joint(j);
    const Role role = request_.roles[j.value()];
    Seat seat = SeatBefore(j);
    if (role == Role::kConstant) {
      const double q = request_.angles[j.value()];
      seat.X_NJ.R = seat.X_NJ.R * AxisRotation<double>(joint.axis, std::sin(q), std::cos(q));
    } else {
      if (!JoinsNode(seat, joint, role)) {
        ModelNode node;
        node.parent = seat.node;
        node.p_P = seat.X_NJ.p;
        node.role = role;
        seat.node = static_cast<int>(model_.nodes.size());
        seat.X_NJ.p.setZero();
        model_.nodes.push_back(node);
      }
      ModelNode& node = model_.nodes[seat.node];
      const Vec3 axis = seat.X_NJ.R * joint.axis;
      node.hinges[node.num_hinges++] = HingeAbout(axis, j.value());
    }
    seat.num_hinges = model_.nodes[seat.node].num_hinges;
    seats_[j.value()] = seat;
    const RigidInertia& body = figure_.body(j);
    RigidInertia& whole = model_.nodes[seat.node].body;
    if (!body.is_massless()) whole = Combine(whole, Moved(body, seat.X_NJ));
  }

  // A hinge concentric with the node it sits on, and of the same joint, is one more of the node's.
  bool JoinsNode(const Seat& seat, const Joint& joint, Role role) const {
    const ModelNode& node = model_.nodes[seat.node];
    if (node.num_hinges == 0 || seat.node == 0 || node.role != role) return false;
    const JointIndex last(node.hinges[node.num_hinges - 1].coordinate);
    return figure_.joint(last).group == joint.group && node.body.is_massless();
  }

  static void FinishNode(ModelNode* node) {
    const auto& h = node->hinges;
    node->is_ball = node->role == Role::kFree && node->num_hinges == 3 &&
                    HingeTriple::Fits(h[0].axis, h[1].axis, h[2].axis);
  }

  const Figure& figure_;
  const ModelRequest& request_;
  std::vector<Seat> seats_;  // by JointIndex, after it turned
  RegionModel model_;
};

bool RootAnswers(const RegionModel& model) {
  if (model.coupling == RootCoupling::kFlight) return true;
  if (model.coupling == RootCoupling::kPrescribed) return false;
  for (int i = model.pin_node; i >= 0; i = model.nodes[i].parent) {
    if (model.nodes[i].role == Role::kFree) return true;
  }
  return false;
}

// Takes parts of a model out. A part takes no longer than it is large: there may be as many as
// there are joints.
class Extraction {
 public:
  explicit Extraction(const RegionModel& whole)
      : whole_(whole), renamed_(whole.nodes.size(), -1), header_(whole) {
    header_.nodes.clear();
    header_.joints.clear();
  }

  // The nodes at or beyond each of `tops`, which ascend, as a model of their own, after the chains
  // that move them, and those that move what `ends` are on.
  RegionModel Take(const std::vector<int>& tops, const std::vector<NodeJoint>& ends) {
    const std::vector<int> carriers = Carriers(tops, ends);
    part_ = header_;
    part_.nodes.reserve(carriers.size() + static_cast<size_t>(EndOf(tops.front()) - tops.front()));
    for (const int i : carriers) Add(i, /*of_island=*/false);
    for (const int top : tops) {
      for (int i = top; i < EndOf(top); ++i) Add(i, /*of_island=*/true);
    }
    if (whole_.pin_node >= 0) part_.pin_node = renamed_[whole_.pin_node];
    for (const NodeJoint& end : ends) AddJoint(end);
    for (const int top : tops) AddJoints(top);
    return std::move(part_);
  }

  // The nodes at or beyond another come right after it, as the joints of a figure do.
  int EndOf(int top) const {
    int end = top + 1;
    while (end < static_cast<int>(whole_.nodes.size()) && whole_.nodes[end].parent >= top) ++end;
    return end;
  }

 private:
  // Of nodes, ends and pin, from the root on.
  std::vector<int> Carriers(const std::vector<int>& tops,
                            const std::vector<NodeJoint>& ends) const {
    std::vector<int> carriers = {0};
    const auto add_from = [&](int node) {
      for (int i = node; i > 0; i = whole_.nodes[i].parent) carriers.push_back(i);
    };
    for (const int top : tops) add_from(whole_.nodes[top].parent);
    for (const NodeJoint& end : ends) add_from(end.node);
    add_from(whole_.pin_node);
    std::sort(carriers.begin(), carriers.end());
    carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
    for (const int top : tops) {
      const int end = EndOf(top);
      std::erase_if(carriers, [&](int i) { return top <= i && i < end; });
    }
    return carriers;
  }

  void Add(int i, bool of_island) {
    renamed_[i] = static_cast<int>(part_.nodes.size());
    part_.nodes.push_back(whole_.nodes[i]);
    ModelNode& node = part_.nodes.back();
    node.parent = node.parent < 0 ? -1 : renamed_[node.parent];
    node.is_dynamic = of_island;
    if (!of_island) node.body = RigidInertia();
  }

  void AddJoint(NodeJoint seat) {
    seat.node = renamed_[seat.node];
    part_.joints.push_back(seat);
  }
  void AddJoints(int top) {
    const auto is_before = [](const NodeJoint& seat, int node) { return seat.node < node; };
    const auto& all = whole_.joints;
    const auto first = std::lower_bound(all.begin(), all.end(), top, is_before);
    const auto last = std::lower_bound(first, all.end(), EndOf(top), is_before);
    std::for_each(first, last, [&](const NodeJoint& seat) { AddJoint(seat); });
  }

  const RegionModel& whole_;
  std::vector<int> renamed_;  // by node of the whole
  RegionModel header_;        // without nodes
  RegionModel part_;
};

// The free nodes that no free node carries.
std::vector<int> FirstFree(const RegionModel& model) {
  std::vector<char> is_carried(model.nodes.size(), 0);
  std::vector<int> first;
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    const int parent = model.nodes[i].parent;
    is_carried[i] = parent >= 0 && (is_carried[parent] || model.nodes[parent].role == Role::kFree);
    if (model.nodes[i].role == Role::kFree && !is_carried[i]) first.push_back(static_cast<int>(i));
  }
  return first;
}

// First free nodes whose islands are one, and what ties hold on to outside of it.
struct Group {
  std::vector<int> tops;        // ascending
  std::vector<NodeJoint> ends;  // on nodes of the whole model that no free node carries
};

// None, or one that is there already, is not added.
void AddEnd(const NodeJoint* end, Group* group) {
  const auto is_that = [&](const NodeJoint& own) { return own.joint == end->joint; };
  if (!end || std::any_of(group->ends.begin(), group->ends.end(), is_that)) return;
  group->ends.push_back(*end);
}

// In order of their first nodes.
std::vector<Group> GroupsOf(const RegionModel& whole, const std::vector<ModelRequest::Tie>& ties,
                            const Extraction& extraction) {
  const std::vector<int> tops = FirstFree(whole);
  std::vector<Group> groups;
  groups.reserve(tops.size());
  for (const int top : tops) groups.push_back({{top}, {}});
  // Where it is in `groups`; -1: no free node carries it.
  const auto group_of = [&](const NodeJoint* seat) {
    for (size_t g = 0; g < groups.size() && seat; ++g) {
      for (const int top : groups[g].tops) {
        if (top <= seat->node && seat->node < extraction.EndOf(top)) return static_cast<int>(g);
      }
    }
    return -1;
  };
  for (const ModelRequest::Tie& tie : ties) {
    const NodeJoint* a = tie.a ? whole.SeatOf(*tie.a) : nullptr;
    const NodeJoint* b = tie.b ? whole.SeatOf(*tie.b) : nullptr;
    const int of_a = group_of(a), of_b = group_of(b);
    if (of_a >= 0 && of_b < 0) AddEnd(b, &groups[of_a]);
    if (of_b >= 0 && of_a < 0) AddEnd(a, &groups[of_b]);
    if (of_a < 0 || of_b < 0 || of_a == of_b) continue;
    Group& into = groups[std::min(of_a, of_b)];
    Group& from = groups[std::max(of_a, of_b)];
    into.tops.insert(into.tops.end(), from.tops.begin(), from.tops.end());
    into.ends.insert(into.ends.end(), from.ends.begin(), from.ends.end());
    std::sort(into.tops.begin(), into.tops.end());
    groups.erase(groups.begin() + std::max(of_a, of_b));
  }
  return groups;
}

void Count(RegionModel* model) {
  model->mass = 0.0;
  model->num_free = model->num_bodies = 0;
  for (const ModelNode& node : model->nodes) {
    if (node.role == Role::kFree) model->num_free += node.num_hinges;
    if (!node.is_dynamic || node.body.is_massless()) continue;
    model->mass += node.body.mass;
    ++model->num_bodies;
  }
}

}  // namespace

const NodeJoint* RegionModel::SeatOf(JointIndex joint) const {
  const auto seat = std::find_if(joints.begin(), joints.end(),
                                 [&](const NodeJoint& own) { return own.joint == joint; });
  return seat == joints.end() ? nullptr : &*seat;
}

std::vector<RegionModel> CompileRegionModels(const Figure& figure, const ModelRequest& request) {
  RegionModel whole = ModelCompiler(figure, request).Compile();
  whole.root_answers = RootAnswers(whole);
  std::vector<RegionModel> models;
  if (whole.root_answers) {
    for (ModelNode& node : whole.nodes) node.is_dynamic = true;
    models.push_back(std::move(whole));
  } else {
    Extraction extraction(whole);
    const std::vector<Group> groups = GroupsOf(whole, request.ties, extraction);
    models.reserve(groups.size());
    for (const Group& group : groups) models.push_back(extraction.Take(group.tops, group.ends));
  }
  for (RegionModel& model : models) Count(&model);
  return models;
}

std::vector<char> WeightlessNodes(const RegionModel& model) {
  std::vector<char> weightless(model.nodes.size(), 1);
  for (int i = static_cast<int>(model.nodes.size()) - 1; i >= 0; --i) {
    const ModelNode& node = model.nodes[i];
    weightless[i] &= node.body.is_massless();
    if (node.parent >= 0) weightless[node.parent] &= weightless[i];
    weightless[i] &= node.role == Role::kFree;
  }
  return weightless;
}

}  // namespace hazumi
