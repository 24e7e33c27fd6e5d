#include "engine/project/edits/curves.h"

#include "engine/project/edits/entries.h"

namespace hazumi {

std::optional<int> RootCurveNamed(const std::string& name) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    if (name == kRootCurveNames[i]) return i;
  }
  return std::nullopt;
}

std::string NameOfCurve(const ProjectHeldObject& object, int axis) {
  return "held." + object.name + "." + "xyz"[axis];
}

std::optional<ObjectCurve> ObjectCurveNamed(const std::string& name, const Project& project) {
  if (!name.starts_with("held.")) return std::nullopt;
  for (size_t i = 0; i < project.held_objects.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (NameOfCurve(project.held_objects[i], axis) == name) return ObjectCurve{i, axis};
    }
  }
  return std::nullopt;
}

bool HasKeys(const ProjectHeldObject& object) { return !object.position.curves[0].keys.empty(); }

Result<ProjectCurve*> CurveNamed(const std::string& name, const Figure& figure, Project* project) {
  if (const auto root = RootCurveNamed(name)) return &project->root.curves[*root];
  if (const auto held = ObjectCurveNamed(name, *project)) {
    return &project->held_objects[held->object].position.curves[held->axis];
  }
  for (Named<ProjectCurve>& entry : project->joints) {
    if (entry.name == name) return &entry.value;
  }
  if (!figure.FindJoint(name)) {
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

}  // namespace hazumi
