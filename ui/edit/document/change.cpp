#include "ui/edit/document/change.h"

#include <algorithm>
#include <utility>

namespace hazumi::edit {

namespace {

constexpr size_t kJoints = 0;  // number of the joints' curves among the parts

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
size_t BytesOfDrives(const std::vector<ProjectDrive>& drives) {
  size_t sum = 0;
  for (const ProjectDrive& drive : drives) {
    sum += sizeof drive + drive.joints.capacity() * sizeof(JointRef) + BytesOf(drive.torque) +
           BytesOf(drive.frequency_over_time) + BytesOf(drive.strength_over_time);
  }
  return sum;
}
size_t BytesOf(const ProjectRegion& region) {
  return sizeof region + region.joints.capacity() * sizeof(JointRef) +
         region.friction.joints.capacity() * sizeof(Named<double>) + BytesOfDrives(region.drives);
}
// Shared with the project.
size_t BytesOf(const ProjectSkin& skin) { return sizeof skin; }
size_t BytesOf(const ProjectMarker& marker) { return sizeof marker + marker.name.capacity(); }
size_t BytesOf(const ProjectSelectionSet& set) {
  return sizeof set + set.joints.capacity() * sizeof(JointRef);
}
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

template <typename Self, typename Action, typename... Projects>
void Change::ForEachPart(Self& self, Action&& action, Projects&... projects) {
  [&]<size_t... I>(std::index_sequence<I...>) {
    const auto one = [&](auto number) {
      constexpr size_t kNumber = decltype(number)::value;
      action(std::get<kNumber>(self.parts_), std::get<kNumber>(PartsOfProject(projects))...);
    };
    (one(std::integral_constant<size_t, I>()), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Parts>>());
}

Change::Change(const Project& before, const Project& after) {
  ForEachPart(
      *this,
      [](auto& part, const auto& old, const auto& now) {
        using Part = typename std::decay_t<decltype(part)>::element_type;
        if (old != now) part.reset(new Part{old, now});
      },
      before, after);
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
  ForEachPart(*this, [&](const auto& part) { is_empty = is_empty && !part; });
  return is_empty;
}

void Change::Apply(Project* project) const {
  ForEachPart(
      *this,
      [](const auto& part, auto& value) {
        if (part) value = part->after;
      },
      *project);
  for (const CurveValues& curve : curves_) {
    CurveOf(curve.of_root, curve.index, project) = curve.after;
  }
}

void Change::Revert(Project* project) const {
  for (const CurveValues& curve : curves_) {
    CurveOf(curve.of_root, curve.index, project) = curve.before;
  }
  ForEachPart(
      *this,
      [](const auto& part, auto& value) {
        if (part) value = part->before;
      },
      *project);
}

size_t Change::bytes() const {
  size_t sum = sizeof *this;
  ForEachPart(*this, [&](const auto& part) {
    if (part) sum += BytesOf(part->before) + BytesOf(part->after);
  });
  for (const CurveValues& curve : curves_) {
    sum += sizeof curve + BytesOf(curve.before) + BytesOf(curve.after);
  }
  return sum;
}

}  // namespace hazumi::edit
