#include "ui/edit/operator.h"

#include <algorithm>

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/held/object_curves.h"
#include "ui/edit/operators/placement/root_curves.h"

namespace hazumi::edit {

namespace {

bool HasHinge(const std::string& name, const Figure& figure) {
  return std::any_of(figure.joints().begin(), figure.joints().end(),
                     [&](const Joint& joint) { return joint.name == name; });
}

std::vector<Operator> Collect() {
  std::vector<Operator> all;
  for (auto&& list : {FieldOperators(),        MediaOperators(),        FigureOperators(),
                      FlightOperators(),       HeldObjectOperators(),   HolderOperators(),
                      JumpOperators(),         JointStateOperators(),   KeyOperators(),
                      KeySelectionOperators(), ObjectOperators(),       PlacementOperators(),
                      PoseBlendOperators(),    PoseOperators(),         ReachOperators(),
                      RegionOperators(),       RootOperators(),         SceneOperators(),
                      SelectedKeyOperators(),  SelectionSetOperators(), ImportOperators(),
                      ExportOperators(),       SessionOperators(),      StartRateOperators(),
                      SwivelOperators(),       ThrowOperators(),        MadeThrowOperators(),
                      TimeOperators(),         DriveOperators(),        ForceOperators(),
                      ConstraintOperators(),   RegionJointOperators()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  std::sort(all.begin(), all.end(), [](const Operator& a, const Operator& b) {
    return std::string_view(a.id) < std::string_view(b.id);
  });
  return all;
}

}  // namespace

const std::vector<Operator>& AllOperators() {
  static const std::vector<Operator> all = Collect();
  return all;
}

const Operator* FindOperator(const std::string& id) {
  for (const Operator& op : AllOperators()) {
    if (op.id == id) return &op;
  }
  return nullptr;
}

Result<ProjectCurve*> CurveNamed(const std::string& name, const Figure& figure, Project* project) {
  if (const auto root = RootCurveNamed(name)) return &project->root.curves[*root];
  if (const auto held = ObjectCurveNamed(name, *project)) {
    return &project->held_objects[held->object].position.curves[held->axis];
  }
  for (Named<ProjectCurve>& entry : project->joints) {
    if (entry.name == name) return &entry.value;
  }
  if (!HasHinge(name, figure)) {
    return Refusal("curve", "\"" + name +
                                "\" is neither a hinge of the figure nor one of root.x, " +
                                "root.y, root.z, root.angle_z, root.angle_y, root.angle_x");
  }
  project->joints.push_back({name, {}});
  return &project->joints.back().value;
}

const ProjectCurve* FindCurve(const std::string& name, const Project& project) {
  if (const auto root = RootCurveNamed(name)) return &project.root.curves[*root];
  if (const auto held = ObjectCurveNamed(name, project)) {
    return &project.held_objects[held->object].position.curves[held->axis];
  }
  for (const Named<ProjectCurve>& entry : project.joints) {
    if (entry.name == name) return &entry.value;
  }
  return nullptr;
}

std::vector<std::string> CurveNames(const Project& project) {
  std::vector<std::string> names(std::begin(kRootCurveNames), std::end(kRootCurveNames));
  for (const Named<ProjectCurve>& entry : project.joints) names.push_back(entry.name);
  for (const ProjectHeldObject& object : project.held_objects) {
    for (int axis = 0; axis < 3 && HasKeys(object); ++axis) {
      names.push_back(NameOfCurve(object, axis));
    }
  }
  return names;
}

std::vector<std::string> CurvesOf(const std::set<std::string>& joints, const Figure& figure) {
  std::vector<std::string> curves;
  for (const std::string& name : joints) {
    if (name != figure.root_name()) curves.push_back(name);
  }
  if (joints.contains(figure.root_name())) {
    curves.insert(curves.end(), std::begin(kRootCurveNames), std::end(kRootCurveNames));
  }
  return curves;
}

ProjectKey* KeyOn(double frame, ProjectCurve* curve) {
  return const_cast<ProjectKey*>(KeyOn(frame, std::as_const(*curve)));
}

const ProjectKey* KeyOn(double frame, const ProjectCurve& curve) {
  const auto key = std::lower_bound(curve.keys.begin(), curve.keys.end(), frame,
                                    [](const ProjectKey& k, double f) { return k.frame < f; });
  return key != curve.keys.end() && key->frame == frame ? &*key : nullptr;
}

void PutKey(const ProjectKey& key, ProjectCurve* curve) {
  if (ProjectKey* there = KeyOn(key.frame, curve)) {
    ExtraFields extra = std::move(there->extra);
    *there = key;
    if (key.extra.empty()) there->extra = std::move(extra);
    return;
  }
  const auto is_before = [](const ProjectKey& a, const ProjectKey& b) { return a.frame < b.frame; };
  curve->keys.insert(std::lower_bound(curve->keys.begin(), curve->keys.end(), key, is_before), key);
}

}  // namespace hazumi::edit
