#include "ui/edit/session/renew_fills.h"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/keys.h"
#include "engine/timeline/curve_track.h"

namespace hazumi::edit {

namespace {

bool IsGenerated(const ProjectKey& key) { return key.type == KeyType::kGenerated; }

// Visits the curves that fills may write keys into, by name.
template <typename AnyProject, typename Visit>
void ForEachCurve(AnyProject* project, Visit visit) {
  for (auto& joint : project->joints) visit(joint.name, &joint.value);
  for (size_t i = 0; i < kNumRootCurves; ++i) {
    visit(std::string(kRootCurveNames[i]), &project->root.curves[i]);
  }
}

bool HasKey(const ProjectKey& key, const ProjectCurve* curve) {
  const ProjectKey* same = curve ? KeyOn(key.frame, *curve) : nullptr;
  return same && *same == key;
}

// Gives generated keys to the animator that neither earlier project has; without fills, all.
void TakeOver(const FillEdit& edit, Project* after) {
  ForEachCurve(after, [&](const std::string& name, ProjectCurve* curve) {
    if (std::none_of(curve->keys.begin(), curve->keys.end(), IsGenerated)) return;
    const ProjectCurve* before = FindCurve(name, edit.before);
    const ProjectCurve* start = edit.drag_start ? FindCurve(name, *edit.drag_start) : nullptr;
    for (ProjectKey& key : curve->keys) {
      if (!IsGenerated(key)) continue;
      if (!after->fills.empty() && (HasKey(key, before) || HasKey(key, start))) continue;
      key.type = KeyType::kKeyframe;
    }
  });
}

size_t NumGenerated(const Project& project) {
  size_t count = 0;
  ForEachCurve(&project, [&](const std::string&, const ProjectCurve* curve) {
    count +=
        static_cast<size_t>(std::count_if(curve->keys.begin(), curve->keys.end(), IsGenerated));
  });
  return count;
}

// Frames with keys of the animator.
std::set<double> KeyedFrames(const std::string& name, const Project& project) {
  std::set<double> frames;
  if (const ProjectCurve* curve = FindCurve(name, project)) {
    for (const ProjectKey& key : curve->keys) {
      if (!IsGenerated(key)) frames.insert(key.frame);
    }
  }
  return frames;
}

// Hinges of one joint, by their curves.
void CompleteKeysOf(const std::vector<std::string>& hinges, const ProjectFill& fill,
                    const Project& before, Project* after) {
  std::set<double> earlier, now;
  for (const std::string& hinge : hinges) {
    earlier.merge(KeyedFrames(hinge, before));
    now.merge(KeyedFrames(hinge, *after));
  }
  for (const double frame : now) {
    const bool is_inside = frame >= fill.first_frame && frame <= fill.last_frame;
    if (!is_inside || earlier.contains(frame)) continue;
    for (const std::string& hinge : hinges) {
      const ProjectCurve* curve = FindCurve(hinge, *after);
      if (!curve || curve->keys.empty()) continue;
      const ProjectKey* there = KeyOn(frame, *curve);
      if (there && !IsGenerated(*there)) continue;
      const Keys keys = ToKeys(*curve, 1.0);
      ProjectKey key;
      key.frame = frame;
      key.value = WithoutRoundOff(
          CurveTrack(&keys, {after->fps.num, after->fps.den}, 0.0, {}).At(frame).value);
      for (auto& joint : after->joints) {
        if (joint.name == hinge) PutKey(key, &joint.value);
      }
    }
  }
}

void CompleteKeys(const Figure& figure, const Project& before, Project* after) {
  for (const ProjectFill& fill : after->fills) {
    const std::vector<bool> filled = JointsOf(fill.joints, figure);
    for (const JointGroup& group : figure.groups()) {
      std::vector<std::string> hinges;
      bool is_filled = false;
      for (int j = group.first.value(); j <= group.last().value(); ++j) {
        hinges.push_back(figure.joint(JointIndex(j)).name);
        is_filled |= filled[static_cast<size_t>(j)];
      }
      if (is_filled && hinges.size() > 1) CompleteKeysOf(hinges, fill, before, after);
    }
  }
}

}  // namespace

Result<std::vector<makers::FillReport>> RenewFills(const FillEdit& edit,
                                                   std::shared_ptr<const Figure> figure,
                                                   Project* after) {
  std::vector<makers::FillReport> none;
  const auto* start = edit.drag_start;
  const bool has_same_list =
      edit.before.fills == after->fills && (!start || start->fills == after->fills);
  if (has_same_list) TakeOver(edit, after);
  if (after->fills.empty()) return none;
  const bool is_same = has_same_list && makers::HaveSameFills(*after, edit.before) &&
                       (!start || makers::HaveSameFills(*after, *start));
  const bool has_all_keys = NumGenerated(*after) >= NumGenerated(edit.before);
  if (is_same && has_all_keys && !edit.is_stale) return none;
  if (!is_same && figure) CompleteKeys(*figure, edit.before, after);
  Result<makers::MadeFills> made = makers::MakeFills(*after, std::move(figure));
  if (!made.ok()) return made.error();
  *after = std::move(made.value().project);
  return std::move(made.value().reports);
}

}  // namespace hazumi::edit
