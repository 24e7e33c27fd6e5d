#include "engine/project/checks/document_checks.h"

#include <cmath>
#include <map>

#include "engine/project/checks/field_checker.h"

namespace hazumi {

namespace {

constexpr double kSlowestRate = 0.1, kFastestRate = 1e4;  // frames per second
constexpr long kMostFrames = 1'000'000;
constexpr int kSolverVersion = 1;

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
  site.Field("version").Report(Check::kNewerSolver, {std::to_string(solver.version)});
}

void CheckOrder(const ProjectKey& before, const ProjectKey& key, const Site& site) {
  if (key.frame == before.frame) site.Report(Check::kKeyTwice, {NumberText(key.frame)});
  if (key.frame < before.frame) {
    site.Report(Check::kKeyOrder, {NumberText(key.frame), NumberText(before.frame)});
  }
}

void CheckCurve(const ProjectCurve& curve, const char* list, const std::string& name,
                const Site& site) {
  for (size_t i = 1; i < curve.keys.size() && site.errors->ok(); ++i) {
    if (curve.keys[i - 1].frame < curve.keys[i].frame) continue;
    CheckOrder(curve.keys[i - 1], curve.keys[i],
               site.Field(list).Field(name).Field("keys").Item(i).Field("frame"));
  }
}

void CheckCurves(const Project& project, const Site& site) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    CheckCurve(project.root.curves[i], "root", kRootCurveNames[i], site);
  }
  for (const auto& joint : project.joints) CheckCurve(joint.value, "joints", joint.name, site);
}

template <typename Item>
void CheckSpan(const Item& item, const Site& site) {
  if (item.first_frame < item.last_frame) return;
  site.Report(Check::kSpanEmpty,
              {std::to_string(item.first_frame), std::to_string(item.last_frame)});
}

void CheckRegion(const ProjectRegion& region, const Site& site) {
  CheckSpan(region, site);
  if (region.joints.empty()) site.Field("joints").Report(Check::kRegionEmpty);
}

// Names of one list: none twice.
template <typename Items>
void CheckNamesUnique(const Items& items, const Site& site) {
  std::map<std::string, size_t> places;
  for (size_t i = 0; i < items.size(); ++i) {
    const auto [it, fresh] = places.emplace(items[i].name, i);
    if (fresh) continue;
    site.Item(i).Field("name").Report(Check::kNameTwice,
                                      {Quoted(items[i].name), site.Item(it->second).place});
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
  CheckNamesUnique(project.scene.objects, objects);
  CheckNamesUnique(project.held_objects, site.Field("held_objects"));
  ForEach(project.scene.objects, objects, [](const auto& object, const Site& place) {
    const auto* plane = std::get_if<ProjectPlane>(&object.shape);
    if (plane) CheckUnitVector(plane->normal, place.Field("plane").Field("normal"));
  });
  if (project.camera) CheckCamera(*project.camera, site.Field("camera"));
}

}  // namespace

void CheckDocument(const Project& project, FirstError* errors) {
  const Site site{"", errors};
  const auto check_span = [](const auto& span, const Site& place) { CheckSpan(span, place); };
  CheckTime(project, site);
  CheckSolver(project.solver, site.Field("solver"));
  FieldChecker fields(errors);
  Describe(fields, project);
  CheckScene(project, site);
  CheckCurves(project, site);
  CheckNamesUnique(project.regions, site.Field("regions"));
  ForEach(project.regions, site.Field("regions"), CheckRegion);
  ForEach(project.placements, site.Field("placements"), check_span);
  ForEach(project.holds, site.Field("holds"), check_span);
}

}  // namespace hazumi
