#include "engine/project/checks/document_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/project/checks/field_checker.h"
#include "engine/project/checks/field_checks.h"
#include "engine/project/items.h"
#include "engine/timeline/solver_rules.h"

namespace hazumi {

namespace {

constexpr double kSlowestRate = 0.1, kFastestRate = 1e4;  // frames per second
constexpr long kMostFrames = 1'000'000;

void CheckFramesOrder(const ProjectFrames& frames, const Site& site) {
  if (frames.first <= frames.last) return;
  site.Report(Check::kFramesReversed, {std::to_string(frames.last), std::to_string(frames.first)});
}

void CheckTime(const Project& project, const Site& site) {
  const double rate = static_cast<double>(project.fps.num) / project.fps.den;
  const bool good = project.fps.den > 0 && rate >= kSlowestRate && rate <= kFastestRate;
  site.errors->Require(good, Check::kBadFrameRate, "fps",
                       {std::to_string(project.fps.num), std::to_string(project.fps.den)});
  CheckFramesOrder(project.frames, site.Field("frames"));
  if (project.preview) CheckFramesOrder(*project.preview, site.Field("preview"));
  const long first = project.frames.first, last = project.frames.last;
  site.errors->Require(last - first < kMostFrames, Check::kTooManyFrames, "frames",
                       {std::to_string(last - first + 1)});
}

void CheckSolver(const ProjectSolver& solver, const Site& site) {
  if (solver.version <= kSolverVersion) return;
  site.Field("version").Report(Check::kNewerSolver,
                               {std::to_string(solver.version), std::to_string(kSolverVersion)});
}

void CheckOrder(const ProjectKey& before, const ProjectKey& key, const Site& site) {
  if (key.frame == before.frame) site.Report(Check::kKeyTwice, {NumberText(key.frame)});
  if (key.frame < before.frame) {
    site.Report(Check::kKeyOrder, {NumberText(key.frame), NumberText(before.frame)});
  }
}

void CheckKeysOrder(const std::vector<ProjectKey>& keys, const char* name, const Site& site) {
  for (size_t i = 1; i < keys.size() && site.errors->ok(); ++i) {
    if (keys[i - 1].frame < keys[i].frame) continue;
    CheckOrder(keys[i - 1], keys[i], site.Field(name).Item(i).Field("frame"));
  }
}

void CheckCurve(const ProjectCurve& curve, const std::string& name, const Site& site) {
  CheckKeysOrder(curve.keys, "keys", site.Field(name));
}

// Each holder begins when the one before it has let go. The first has it from the start.
void CheckHolders(const ProjectHeldObject& object, const Site& site) {
  std::string before = object.joint;
  std::optional<int> end = object.release_frame;
  if (before.empty() && end) site.Field("release_frame").Report(Check::kReleaseByNobody);
  for (size_t i = 0; i < object.holders.size(); ++i) {
    const ProjectHolder& holder = object.holders[i];
    const Site place = site.Field("holders").Item(i);
    if (!before.empty() && holder.first_frame < end.value_or(std::numeric_limits<int>::max())) {
      place.Report(Check::kHoldersOverlap, {std::to_string(holder.first_frame), Quoted(before)});
    }
    before = holder.joint;
    end = holder.last_frame;
    if (end && *end <= holder.first_frame) {
      place.Report(Check::kSpanEmpty, {std::to_string(holder.first_frame), std::to_string(*end)});
    }
  }
}

void CheckPosition(const ProjectPosition& position, const Site& site) {
  constexpr const char* kNames[] = {"x", "y", "z"};
  const bool any = std::any_of(position.curves.begin(), position.curves.end(),
                               [](const ProjectCurve& curve) { return !curve.keys.empty(); });
  for (int i = 0; i < 3; ++i) {
    CheckCurve(position.curves[i], kNames[i], site);
    if (any && position.curves[i].keys.empty()) {
      site.Field(kNames[i]).Report(Check::kPositionIncomplete);
    }
  }
}

void CheckCurves(const Project& project, const Site& site) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    CheckCurve(project.root.curves[i], kRootFieldNames[i], site.Field("root"));
  }
  for (const auto& joint : project.joints) {
    CheckCurve(joint.value, joint.name, site.Field("joints"));
  }
}

template <typename Item>
void CheckSpan(const Item& item, const Site& site) {
  if (item.first_frame < item.last_frame) return;
  site.Report(Check::kSpanEmpty,
              {std::to_string(item.first_frame), std::to_string(item.last_frame)});
}

void CheckRegion(const ProjectRegion& region, const ProjectRate& rate, const Site& site) {
  if (region.joints.empty()) site.Field("joints").Report(Check::kRegionEmpty);
  for (size_t i = 0; i < region.drives.size(); ++i) {
    const ProjectDrive& drive = region.drives[i];
    const Site place = site.Field("drives").Item(i);
    if (drive.joints.empty()) place.Field("joints").Report(Check::kDriveEmpty);
    CheckKeysOrder(drive.torque.keys, "keys", place);
    CheckKeysOrder(drive.frequency_over_time.keys, "frequency_keys", place);
    CheckKeysOrder(drive.strength_over_time.keys, "strength_keys", place);
    CheckDriveCurves(drive, rate, place);
  }
}

void CheckSet(const ProjectSelectionSet& set, const Site& site) {
  if (set.joints.empty()) site.Field("joints").Report(Check::kSetEmpty);
}

void CheckFill(const ProjectFill& fill, const Site& site) {
  if (fill.joints.empty()) site.Field("joints").Report(Check::kFillEmpty);
}

void CheckGoal(const ProjectGoal& goal, const Site& site) {
  if (goal.kind == GoalKind::kPose && goal.joints.empty()) {
    site.Field("joints").Report(Check::kGoalEmpty);
  }
}

void CheckCamera(const ProjectCamera& camera, const Site& site) {
  if ((camera.eye_m - camera.target_m).norm() < 1e-9) site.Report(Check::kNoView);
}

template <typename Items, typename CheckItem>
void ForEach(const Items& items, const Site& site, CheckItem check) {
  for (size_t i = 0; i < items.size(); ++i) check(items[i], site.Item(i));
}

void CheckScene(const Project& project, const Site& site) {
  const Site objects = site.Field("scene").Field("objects");
  ForEach(project.scene.objects, objects, [](const auto& object, const Site& place) {
    const auto* plane = std::get_if<ProjectPlane>(&object.shape);
    if (plane) CheckUnitVector(plane->normal, place.Field("plane").Field("normal"));
  });
  ForEach(project.held_objects, site.Field("held_objects"),
          [](const auto& object, const Site& place) {
            CheckHolders(object, place);
            CheckPosition(object.position, place.Field("position"));
          });
  if (project.camera) CheckCamera(*project.camera, site.Field("camera"));
}

// Checks what all kinds of items have: unique names, and last frames behind the first.
void CheckItems(const Project& project, const Site& site) {
  const auto check = [&]<typename Item>(auto kind, const std::vector<Item>& items) {
    const Site list = site.Field(kind.kList);
    if constexpr (HasUniqueName<Item>) CheckNamesUnique(items, list);
    if constexpr (SpanItem<Item>) {
      ForEach(items, list, [](const Item& item, const Site& place) {
        if (!IsOneFrame(item)) CheckSpan(item, place);
      });
    }
  };
  ForEachItemList(check, project);
}

}  // namespace

void CheckDocument(const Project& project, FirstError* errors) {
  const Site site{"", errors};
  CheckTime(project, site);
  CheckSolver(project.solver, site.Field("solver"));
  FieldChecker fields(errors);
  Describe(fields, project);
  CheckScene(project, site);
  CheckCurves(project, site);
  CheckNamesUnique(project.selection_sets, site.Field("selection_sets"));
  ForEach(project.selection_sets, site.Field("selection_sets"), CheckSet);
  ForEach(project.fills, site.Field("fills"), CheckFill);
  ForEach(project.goals, site.Field("goals"), CheckGoal);
  CheckItems(project, site);
  ForEach(project.regions, site.Field("regions"),
          [&](const ProjectRegion& region, const Site& place) {
            CheckRegion(region, project.fps, place);
          });
}

}  // namespace hazumi
