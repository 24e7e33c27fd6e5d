#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
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
  template <typename T>
  struct PartsOf;
  template <typename... T>
  struct PartsOf<std::tuple<const T&...>> {
    using type = std::tuple<std::unique_ptr<Values<T>>...>;
  };
  using Parts = PartsOf<decltype(PartsOfProject(std::declval<const Project&>()))>::type;
  // A curve of the root, or of an entry of Project::joints.
  struct CurveValues {
    bool of_root;
    size_t index;
    ProjectCurve before, after;
  };

  // action(part, its values in the projects ...) for each part.
  template <typename Self, typename Action, typename... Projects>
  static void ForEachPart(Self& self, Action&& action, Projects&... projects);
  void Compare(bool of_root, size_t index, const ProjectCurve& before, const ProjectCurve& after);

  Parts parts_;  // null where equal
  std::vector<CurveValues> curves_;
};

// Both inclusive.
struct FrameSpan {
  double first, last;
  bool operator==(const FrameSpan&) const = default;
};

// The frames of what two states of a project differ in, in no order: of keys and markers their
// frames, of what has a beginning and an end the part that was added or taken away, or all of it if
// something else about it differs. What has no frame, such as a name, gives none.
std::vector<FrameSpan> ChangedFrames(const Project& before, const Project& after);

}  // namespace hazumi::edit
