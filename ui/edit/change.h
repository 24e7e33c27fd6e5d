#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/project/project.h"

namespace hazumi::edit {

// What an edit did to a project: the parts that differ, before and after.
class Change {
 public:
  Change(const Project& before, const Project& after);

  bool is_empty() const;
  void Apply(Project* project) const;   // from before to after
  void Revert(Project* project) const;  // and back
  // Memory that it holds, about.
  size_t bytes() const;

 private:
  template <typename T>
  struct Values {
    T before, after;
  };
  template <typename... T>
  using PartsOf = std::tuple<std::unique_ptr<Values<T>>...>;
  // In the order of Members() in change.cpp.
  using Parts =
      PartsOf<std::string, ProjectRate, ProjectFrames, ProjectSolver, ProjectFigure, ProjectScene,
              ExtraFields, std::vector<Named<ProjectCurve>>, std::vector<ProjectRegion>,
              std::vector<ProjectPlacement>, std::vector<ProjectHold>,
              std::vector<ProjectHeldObject>, std::optional<ProjectCamera>,
              std::vector<ProjectMarker>, std::optional<ProjectFrames>, ExtraFields>;
  // A curve of the root, or of an entry of Project::joints.
  struct CurveValues {
    bool of_root;
    size_t index;
    ProjectCurve before, after;
  };

  template <typename Action>
  void ForEachPart(Action&& action);
  template <typename Action>
  void ForEachPart(Action&& action) const;
  void Compare(bool of_root, size_t index, const ProjectCurve& before, const ProjectCurve& after);

  Parts parts_;  // null where equal
  std::vector<CurveValues> curves_;
};

}  // namespace hazumi::edit
