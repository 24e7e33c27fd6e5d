#include "ui/edit/change.h"

#include <algorithm>
#include <utility>

namespace hazumi::edit {

namespace {

// Where the parts are in a project. Each takes a project, constant or not.
constexpr auto Members() {
  return std::make_tuple(
      [](auto& p) -> auto& { return p.name; }, [](auto& p) -> auto& { return p.fps; },
      [](auto& p) -> auto& { return p.frames; }, [](auto& p) -> auto& { return p.solver; },
      [](auto& p) -> auto& { return p.figure; }, [](auto& p) -> auto& { return p.scene; },
      [](auto& p) -> auto& { return p.root.extra; }, [](auto& p) -> auto& { return p.joints; },
      [](auto& p) -> auto& { return p.regions; }, [](auto& p) -> auto& { return p.placements; },
      [](auto& p) -> auto& { return p.holds; }, [](auto& p) -> auto& { return p.held_objects; },
      [](auto& p) -> auto& { return p.camera; }, [](auto& p) -> auto& { return p.markers; },
      [](auto& p) -> auto& { return p.preview; }, [](auto& p) -> auto& { return p.extra; });
}
constexpr size_t kJoints = 7;  // number of the joints' curves among them

ProjectCurve& CurveOf(bool of_root, size_t index, Project* project) {
  return of_root ? project->root.curves[index] : project->joints[index].value;
}

bool HaveSameNames(const std::vector<Named<ProjectCurve>>& a,
                   const std::vector<Named<ProjectCurve>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.name == y.name; });
}

template <typename T>
size_t BytesOf(const T&) {
  return sizeof(T);
}
size_t BytesOf(const std::string& text) { return sizeof(std::string) + text.capacity(); }
size_t BytesOf(const ProjectCurve& curve) {
  return sizeof curve + curve.keys.capacity() * sizeof(ProjectKey);
}
size_t BytesOf(const ProjectFigure& figure) {
  return sizeof figure + figure.embedded_json.capacity() +
         figure.spec.joints.capacity() * sizeof(JointSpec);
}
size_t BytesOf(const ProjectRegion& region) {
  return sizeof region + region.joints.capacity() * sizeof(JointRef) +
         region.friction.joints.capacity() * sizeof(Named<double>);
}
size_t BytesOf(const ProjectMarker& marker) { return sizeof marker + marker.name.capacity(); }
size_t BytesOf(const Named<ProjectCurve>& entry) {
  return BytesOf(entry.name) + BytesOf(entry.value);
}
template <typename T>
size_t BytesOf(const std::vector<T>& values) {
  size_t sum = 0;
  for (const T& value : values) sum += BytesOf(value);
  return sum;
}

}  // namespace

// `action(part, member)` for each part.
template <typename Action>
void Change::ForEachPart(Action&& action) {
  constexpr auto kMembers = Members();
  [&]<size_t... I>(std::index_sequence<I...>) {
    (action(std::get<I>(parts_), std::get<I>(kMembers)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Parts>>());
}
template <typename Action>
void Change::ForEachPart(Action&& action) const {
  constexpr auto kMembers = Members();
  [&]<size_t... I>(std::index_sequence<I...>) {
    (action(std::get<I>(parts_), std::get<I>(kMembers)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Parts>>());
}

Change::Change(const Project& before, const Project& after) {
  ForEachPart([&](auto& part, const auto& member) {
    using Part = typename std::decay_t<decltype(part)>::element_type;
    if (member(before) != member(after)) part.reset(new Part{member(before), member(after)});
  });
  if (HaveSameNames(before.joints, after.joints)) {
    std::get<kJoints>(parts_).reset();
    for (size_t i = 0; i < before.joints.size(); ++i) {
      Compare(false, i, before.joints[i].value, after.joints[i].value);
    }
  }
  for (size_t i = 0; i < before.root.curves.size(); ++i) {
    Compare(true, i, before.root.curves[i], after.root.curves[i]);
  }
}

void Change::Compare(bool of_root, size_t index, const ProjectCurve& before,
                     const ProjectCurve& after) {
  if (before != after) curves_.push_back({of_root, index, before, after});
}

bool Change::is_empty() const {
  bool is_empty = curves_.empty();
  ForEachPart([&](const auto& part, const auto&) { is_empty = is_empty && !part; });
  return is_empty;
}

void Change::Apply(Project* project) const {
  ForEachPart([&](const auto& part, const auto& member) {
    if (part) member(*project) = part->after;
  });
  for (const CurveValues& curve : curves_) {
    CurveOf(curve.of_root, curve.index, project) = curve.after;
  }
}

void Change::Revert(Project* project) const {
  for (const CurveValues& curve : curves_) {
    CurveOf(curve.of_root, curve.index, project) = curve.before;
  }
  ForEachPart([&](const auto& part, const auto& member) {
    if (part) member(*project) = part->before;
  });
}

size_t Change::bytes() const {
  size_t sum = sizeof *this;
  ForEachPart([&](const auto& part, const auto&) {
    if (part) sum += BytesOf(part->before) + BytesOf(part->after);
  });
  for (const CurveValues& curve : curves_) {
    sum += sizeof curve + BytesOf(curve.before) + BytesOf(curve.after);
  }
  return sum;
}

}  // namespace hazumi::edit
