#include "engine/passive/region_model.h"

#include <algorithm>
#include <cmath>

#include "engine/passive/hinge_triple.h"

namespace hazumi {

namespace {

// Where the frame of a joint sits: fixed to a node.
struct Seat {
  int node = 0;
  Pose X_NJ;
};

RigidInertia Moved(const RigidInertia& body, const Pose& X) {
  return {body.mass, X * body.com, X.R * body.I_com * X.R.transpose()};
}

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

  // The frame of joint j, before it turns.
  Seat SeatBefore(JointIndex j) const {
    const Joint& joint = figure_.joint(j);
    const Seat parent = joint.parent.is_valid() ? seats_[joint.parent.value()] : Seat();
    return {parent.node, parent.X_NJ * joint.X_PJ};
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

bool IsBetween(const RegionModel& model, int node, int end) {
  for (int i = end; i >= 0; i = model.nodes[i].parent) {
    if (i == node) return true;
  }
  return false;
}

bool RootAnswers(const RegionModel& model) {
  if (model.coupling == RootCoupling::kFlight) return true;
  if (model.coupling == RootCoupling::kPrescribed) return false;
  for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
    if (model.nodes[i].role == Role::kFree && IsBetween(model, i, model.pin_node)) return true;
  }
  return false;
}

// The nodes at or beyond `top` as a model of their own, after the chains that move them.
RegionModel Extract(const RegionModel& whole, int top) {
  const int n = static_cast<int>(whole.nodes.size());
  std::vector<char> kept(n, 0), dynamic(n, 0);
  kept[0] = 1;
  for (int i = 0; i < n; ++i) {
    dynamic[i] = i == top || (whole.nodes[i].parent >= 0 && dynamic[whole.nodes[i].parent]);
  }
  for (int i = 0; i < n; ++i) kept[i] |= dynamic[i];
  for (int i = top; i >= 0; i = whole.nodes[i].parent) kept[i] = 1;
  for (int i = whole.pin_node; i >= 0; i = whole.nodes[i].parent) kept[i] = 1;
  RegionModel part = whole;
  part.nodes.clear();
  std::vector<int> renamed(n, -1);
  for (const bool of_group : {false, true}) {
    for (int i = 0; i < n; ++i) {
      if (!kept[i] || (dynamic[i] != 0) != of_group) continue;
      renamed[i] = static_cast<int>(part.nodes.size());
      part.nodes.push_back(whole.nodes[i]);
      ModelNode& node = part.nodes.back();
      node.parent = node.parent < 0 ? -1 : renamed[node.parent];
      node.is_dynamic = of_group;
      if (!of_group) node.body = RigidInertia();
    }
  }
  if (whole.pin_node >= 0) part.pin_node = renamed[whole.pin_node];
  return part;
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

bool HasFreeAncestor(const RegionModel& model, int node) {
  for (int i = model.nodes[node].parent; i >= 0; i = model.nodes[i].parent) {
    if (model.nodes[i].role == Role::kFree) return true;
  }
  return false;
}

}  // namespace

std::vector<RegionModel> CompileRegionModels(const Figure& figure, const ModelRequest& request) {
  RegionModel whole = ModelCompiler(figure, request).Compile();
  whole.root_answers = RootAnswers(whole);
  std::vector<RegionModel> models;
  if (whole.root_answers) {
    for (ModelNode& node : whole.nodes) node.is_dynamic = true;
    models.push_back(std::move(whole));
  } else {
    for (int i = 0; i < static_cast<int>(whole.nodes.size()); ++i) {
      if (whole.nodes[i].role != Role::kFree || HasFreeAncestor(whole, i)) continue;
      models.push_back(Extract(whole, i));
    }
  }
  for (RegionModel& model : models) Count(&model);
  return models;
}

}  // namespace hazumi
