#pragma once

// Internal: what the operators are made of.

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/spatial/degrees.h"
#include "ui/edit/operator.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// Each gives the operators of one file.
std::vector<Operator> ConstraintOperators();
std::vector<Operator> DriveOperators();
std::vector<Operator> FieldOperators();
std::vector<Operator> MediaOperators();
std::vector<Operator> ExportOperators();
std::vector<Operator> FigureOperators();
std::vector<Operator> FlightOperators();
std::vector<Operator> ForceOperators();
std::vector<Operator> HeldObjectOperators();
std::vector<Operator> HolderOperators();
std::vector<Operator> JumpOperators();
std::vector<Operator> JointStateOperators();
std::vector<Operator> KeyOperators();
std::vector<Operator> KeySelectionOperators();
std::vector<Operator> ObjectOperators();
std::vector<Operator> PlacementOperators();
std::vector<Operator> PoseBlendOperators();
std::vector<Operator> PoseOperators();
std::vector<Operator> ReachOperators();
std::vector<Operator> RegionJointOperators();
std::vector<Operator> RegionOperators();
std::vector<Operator> RootOperators();
std::vector<Operator> SceneOperators();
std::vector<Operator> SelectedKeyOperators();
std::vector<Operator> SelectionSetOperators();
std::vector<Operator> ImportOperators();
std::vector<Operator> SessionOperators();
std::vector<Operator> StartRateOperators();
std::vector<Operator> SwivelOperators();
std::vector<Operator> ThrowOperators();
std::vector<Operator> MadeThrowOperators();
std::vector<Operator> TimeOperators();

// 60 degrees come back from radians as 60, not as 59.99999999999999.
inline double WithoutRoundOff(double degrees) { return std::round(degrees * 1e9) / 1e9; }

// For whatever can be dragged.
inline const ParameterInfo kDrag = {"drag", ParameterKind::kText, false,
                                    "edits in a row with the same text are one undo step"};

inline Error Refusal(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

// A curve by its name: a hinge's, or "root.x" to "root.angle_x". A hinge without one is given one.
// Errors: kSchema if the figure has no such hinge.
Result<ProjectCurve*> CurveNamed(const std::string& name, const Figure& figure, Project* project);
// The same, without giving one: null if the hinge has none.
const ProjectCurve* FindCurve(const std::string& name, const Project& project);
// Names of all curves that a project has: of its root and of hinges that have one.
std::vector<std::string> CurveNames(const Project& project);
// Of hinges, and of the root its six.
std::vector<std::string> CurvesOf(const std::set<std::string>& joints, const Figure& figure);

// A hinge by its name, or all of a joint; the root is its own. Errors: kSchema if there is none of
// this name.
Result<std::vector<std::string>> HingesNamed(const std::string& name, const Figure& figure);

// The joint of the first selected hinge; empty: none is.
std::string FirstSelectedJoint(const Session& session);
// The same; none is: the first one that there is.
std::string LikelyJoint(const Session& session);

// Joints and hinges that name these hinges: a joint of which all are meant by its own name.
std::vector<std::string> JointNames(const std::set<std::string>& hinges, const Figure& figure);
// Names of the selected hinges, and the root first if it is selected.
std::vector<std::string> SelectedNames(const Session& session);

// By the parameter "curves"; not given: those of the selected joints, else all.
std::vector<std::string> ChosenCurves(const Session& session, const Parameters& p);
// All of its tangents follow from the neighbours.
void SetAutomatic(ProjectKey* key);

// Keys angles at the current frame, but for locked hinges: one undo step, or part of a drag.
Result<Done> KeyPose(Session* session, const std::string& label, const Pose& pose,
                     const std::string& drag = "");

// A span of placement; what was said of its frames before gives way. Frames that the root's keys
// place need no span: if not `is_said` there will be none. Errors: kSchema if it has no frames.
Result<Done> PutPlacement(ProjectPlacement span, bool is_said,
                          std::vector<ProjectPlacement>* spans);

// The key on a frame, or null.
ProjectKey* KeyOn(double frame, ProjectCurve* curve);
const ProjectKey* KeyOn(double frame, const ProjectCurve& curve);
// Puts a key in its place; one on the same frame is replaced, but for its fields that no one knows.
void PutKey(const ProjectKey& key, ProjectCurve* curve);

// The entry of a list with this name, or an error that tells the names there are.
template <typename T>
Result<T*> EntryNamed(const std::string& name, const char* what, std::vector<T>* list) {
  std::string known;
  for (T& entry : *list) {
    if (entry.name == name) return &entry;
    known += (known.empty() ? "\"" : ", \"") + entry.name + "\"";
  }
  return Refusal(
      what, "there is no \"" + name + "\"; there " + (known.empty() ? "are none" : "is " + known));
}

// "box" of "box 2".
inline std::string WithoutNumber(const std::string& name) {
  const size_t digits = name.find_last_not_of("0123456789") + 1;
  const bool is_numbered = digits > 1 && digits < name.size() && name[digits - 1] == ' ';
  return is_numbered ? name.substr(0, digits - 1) : name;
}
// The name, or with the next number behind it if another entry of the list has it.
template <typename T>
std::string FreeName(const std::string& wanted, const std::vector<T>& list,
                     const T* own = nullptr) {
  std::string name = wanted;
  const auto is_taken = [&](const T& entry) { return &entry != own && entry.name == name; };
  for (int i = 2; std::any_of(list.begin(), list.end(), is_taken); ++i) {
    name = WithoutNumber(wanted) + " " + std::to_string(i);
  }
  return name;
}

// The same for an object of the scene or a held one: constraints name both.
inline std::string FreeObjectName(const std::string& wanted, const Project& project) {
  std::vector<Named<bool>> objects;
  for (const auto& object : project.scene.objects) objects.push_back({object.name});
  for (const auto& object : project.held_objects) objects.push_back({object.name});
  return FreeName(wanted, objects);
}

// Of an enumeration by its file name, e.g. "exact"; `all`: every value.
template <typename T>
Result<T> ValueNamed(const std::string& name, const char* parameter, std::initializer_list<T> all,
                     const char* (*name_of)(T)) {
  std::string known;
  for (const T value : all) {
    if (name_of(value) == name) return value;
    known += (known.empty() ? "" : ", ") + std::string(name_of(value));
  }
  return Refusal(parameter, "\"" + name + "\" is none of " + known);
}

}  // namespace hazumi::edit
