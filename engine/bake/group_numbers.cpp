#include "engine/bake/group_numbers.h"

namespace hazumi {

namespace {

void AppendBody(const RigidInertia& body, Numbers* numbers) {
  numbers->push_back(body.mass);
  Append(body.com, numbers);
  Append(body.I_com, numbers);
}

void AppendNode(const ModelNode& node, Numbers* numbers) {
  for (const double value :
       {double(node.parent), static_cast<double>(node.role), double(node.num_hinges),
        double(node.is_ball), double(node.is_dynamic)}) {
    numbers->push_back(value);
  }
  Append(node.p_P, numbers);
  AppendBody(node.body, numbers);
  for (int h = 0; h < node.num_hinges; ++h) {
    numbers->push_back(node.hinges[h].coordinate);
    Append(node.hinges[h].axis, numbers);
  }
}

void AppendRoot(const RegionModel& model, Numbers* numbers) {
  Append(model.R_root, numbers);
  Append(model.p_pin, numbers);
  for (const double value :
       {static_cast<double>(model.coupling), double(model.pin_node), double(model.root_answers)}) {
    numbers->push_back(value);
  }
}

// action(curve): each as a function that picks it from a DrivenMotion.
template <typename Action>
void ForEachCurve(const RegionModel& model, size_t num_nodes, Action&& action) {
  for (size_t i = 0; i < num_nodes; ++i) {
    const ModelNode& node = model.nodes[i];
    if (node.role != Role::kDriven) continue;
    for (int h = 0; h < node.num_hinges; ++h) {
      const Coordinate c = node.hinges[h].coordinate;
      action([c](auto& driven) -> auto& { return driven.angles[c]; });
    }
  }
  if (model.coupling != RootCoupling::kPrescribed) return;
  for (int i = 0; i < 3; ++i) {
    action([i](auto& driven) -> auto& { return driven.root_position[i]; });
  }
}

}  // namespace

void AppendTask(const GroupTask& task, Numbers* numbers) {
  AppendRoot(task.model, numbers);
  numbers->push_back(task.model.mass);
  numbers->push_back(static_cast<double>(task.model.nodes.size()));
  for (const ModelNode& node : task.model.nodes) AppendNode(node, numbers);
  for (const VecX* values : {&task.friction, &task.lower, &task.upper}) Append(*values, numbers);
  numbers->push_back(task.gravity);
  numbers->push_back(task.step_tolerance);
}

void AppendCurves(const RegionModel& model, size_t num_nodes, const DrivenMotion& driven,
                  Numbers* numbers) {
  ForEachCurve(model, num_nodes, [&](auto&& of) {
    const DrivenCurve& curve = of(driven);
    numbers->push_back(curve.start);
    numbers->push_back(curve.degree);
    numbers->insert(numbers->end(), curve.c.begin(), curve.c.begin() + curve.degree + 1);
  });
}

void ReadCurves(const RegionModel& model, const double* numbers, DrivenMotion* driven) {
  ForEachCurve(model, model.nodes.size(), [&](auto&& of) {
    DrivenCurve& curve = of(*driven);
    curve = DrivenCurve();
    curve.start = *numbers++;
    curve.degree = static_cast<int>(*numbers++);
    for (int i = 0; i <= curve.degree; ++i) curve.c[i] = *numbers++;
  });
}

Numbers AttachmentKey(const RegionModel& model, int first_moved, double gravity,
                      const DrivenMotion& driven, double t, double end) {
  Numbers key = {t, end, gravity, static_cast<double>(model.nodes[first_moved].parent)};
  AppendRoot(model, &key);
  for (int i = 0; i < first_moved; ++i) AppendNode(model.nodes[i], &key);
  AppendCurves(model, static_cast<size_t>(first_moved), driven, &key);
  return key;
}

}  // namespace hazumi
