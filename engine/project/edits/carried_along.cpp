#include <algorithm>
#include <cmath>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/goals.h"
#include "engine/project/edits/key_selection.h"
#include "engine/project/edits/keys.h"
#include "engine/project/items.h"

namespace hazumi {

namespace {

class KeyCarrier {
 public:
  KeyCarrier(const KeySelection& selected, const FrameMap& to, const Project& project)
      : selected_(selected), to_(to) {
    first_ = last_ = *selected.begin()->second.begin();
    for (const auto& [curve, frames] : selected) {
      first_ = std::min(first_, *frames.begin());
      last_ = std::max(last_, *frames.rbegin());
    }
    for (const std::string& name : CurveNames(project)) {
      if (IsLeftBehind(name, *FindCurve(name, project))) left_behind_.insert(name);
    }
  }

  bool is_one_frame() const { return first_ == last_; }
  bool has_all() const { return left_behind_.empty(); }
  // All keys in between of these curves are selected, and there are some.
  bool HasAllOf(const std::vector<std::string>& curves) const {
    const auto is_in = [](const auto& names) {
      return [&names](const std::string& name) { return names.contains(name); };
    };
    return std::any_of(curves.begin(), curves.end(), is_in(selected_)) &&
           std::none_of(curves.begin(), curves.end(), is_in(left_behind_));
  }

  void Carry(int* frame) const {
    if (*frame < first_ || *frame > last_) return;
    *frame = static_cast<int>(std::lround(to_(*frame)));
  }
  void CarryKeys(ProjectCurve* curve) const {
    for (ProjectKey& key : curve->keys) {
      if (key.frame >= first_ && key.frame <= last_) key.frame = to_(key.frame);
    }
    std::sort(curve->keys.begin(), curve->keys.end(),
              [](const ProjectKey& a, const ProjectKey& b) { return a.frame < b.frame; });
    curve->keys.erase(
        std::unique(curve->keys.begin(), curve->keys.end(),
                    [](const ProjectKey& a, const ProjectKey& b) { return a.frame == b.frame; }),
        curve->keys.end());
  }
  // However short, it stays a bar.
  template <SpanItem Item>
  void CarrySpan(Item* item) const {
    Carry(&item->first_frame);
    if (IsOneFrame(*item)) return;
    Carry(&item->last_frame);
    item->last_frame = std::max(item->last_frame, item->first_frame + 1);
  }
  // Regions are carried by themselves.
  template <typename Kind, typename Item>
  void CarryFrames(Kind kind, Item* item) const {
    if constexpr (std::is_same_v<Item, ProjectRegion>) return;
    if constexpr (SpanItem<Item>) return CarrySpan(item);
    if constexpr (!SpanItem<Item>) kind.ForEachFrame(*item, [&](int& frame) { Carry(&frame); });
  }

 private:
  bool IsLeftBehind(const std::string& name, const ProjectCurve& curve) const {
    return std::any_of(curve.keys.begin(), curve.keys.end(), [&](const ProjectKey& key) {
      return key.type != KeyType::kGenerated && key.frame >= first_ && key.frame <= last_ &&
             !Contains(selected_, name, key.frame);
    });
  }

  const KeySelection& selected_;
  const FrameMap& to_;
  double first_, last_;                // of the selected keys
  std::set<std::string> left_behind_;  // curves with other keys in between
};

std::vector<std::string> HingesOf(const std::vector<JointRef>& joints, const Figure& figure) {
  std::vector<std::string> names;
  const std::vector<bool> moved = JointsOf(joints, figure);
  for (size_t j = 0; j < moved.size(); ++j) {
    if (moved[j]) names.push_back(figure.joints()[j].name);
  }
  return names;
}

std::vector<std::string> CurvesOf(const ProjectFill& fill, const Figure& figure) {
  std::vector<std::string> names = HingesOf(fill.joints, figure);
  if (NameRoot(fill.joints, figure)) {
    names.insert(names.end(), std::begin(kRootCurveNames), std::end(kRootCurveNames));
  }
  return names;
}

std::vector<std::string> CurvesOf(const ProjectRegion& region, const Figure& figure) {
  std::vector<std::string> names = HingesOf(region.joints, figure);
  if (!DrivesRoot(region, figure)) return names;
  for (const char* angle : {"root.angle_z", "root.angle_y", "root.angle_x"}) names.push_back(angle);
  return names;
}

}  // namespace

void CarryAlong(const KeySelection& selected, const Figure& figure, const FrameMap& to,
                Project* project) {
  if (selected.empty()) return;
  const KeyCarrier carrier(selected, to, *project);
  if (carrier.is_one_frame()) return;
  for (ProjectRegion& region : project->regions) {
    if (!carrier.has_all() && !carrier.HasAllOf(CurvesOf(region, figure))) continue;
    // Goals in a region go with it.
    for (ProjectGoal& goal : project->goals) {
      if (carrier.has_all() || !Moves(region, goal, figure, *project)) continue;
      carrier.CarryFrames(ItemKind<ProjectGoal>(), &goal);
    }
    carrier.CarrySpan(&region);
    for (ProjectDrive& drive : region.drives) {
      for (ProjectCurve* curve :
           {&drive.torque, &drive.frequency_over_time, &drive.strength_over_time}) {
        carrier.CarryKeys(curve);
      }
    }
  }
  for (ProjectFill& fill : project->fills) {
    if (!carrier.has_all() && carrier.HasAllOf(CurvesOf(fill, figure))) carrier.CarrySpan(&fill);
  }
  if (!carrier.has_all()) return;
  ForEachItemList(
      [&](auto kind, auto& items) {
        for (auto& item : items) carrier.CarryFrames(kind, &item);
      },
      *project);
}

}  // namespace hazumi
