#pragma once

// Internal: what the operators are made of.

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"
#include "ui/edit/operator.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// For whatever can be dragged.
inline const ParameterInfo kDrag = {"drag", ParameterKind::kText, false,
                                    "edits in a row with the same text are one undo step"};

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
// Keys angles at the current frame, but for locked hinges: one undo step, or part of a drag.
Result<Done> KeyPose(Session* session, const std::string& label, const Pose& pose,
                     const std::string& drag = "");

// Puts another project in the place of the session's: one undo step, or part of a drag.
Result<Done> Put(Session* session, const std::string& label, Project project,
                 const std::string& drag = "");

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
