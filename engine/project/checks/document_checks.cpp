#include "engine/project/checks/document_checks.h"

#include <cmath>
#include <map>

#include "engine/project/checks/field_checks.h"
#include "engine/project/project_fields.h"

namespace hazumi {

namespace {

constexpr double kSlowestRate = 0.1, kFastestRate = 1e4;     // frames per second
constexpr double kShortestStep = 1e-6, kLongestStep = 1.0;   // [s]
constexpr double kFinest = 1e-10, kCoarsest = 5.0;           // tolerances [deg]
constexpr double kNarrowestView = 1.0, kWidestView = 179.0;  // [deg]
constexpr long kMostFrames = 1'000'000;
constexpr int kSolverVersion = 1;

// Files hold no larger numbers.
void CheckWhole(int number, const char* field, const Site& site) {
  if (std::abs(static_cast<double>(number)) > kLargestNumber)
    CheckNumber(number, site.Field(field));
}

void CheckFramesOrder(const ProjectFrames& frames, const Site& site) {
  CheckWhole(frames.first, "first", site);
  CheckWhole(frames.last, "last", site);
  if (frames.first <= frames.last) return;
  site.Report(Check::kFramesReversed, {std::to_string(frames.last), std::to_string(frames.first)});
}

void CheckTime(const Project& project, const Site& site) {
  const double rate = static_cast<double>(project.fps.num) / project.fps.den;
  const bool good = project.fps.den > 0 && rate >= kSlowestRate && rate <= kFastestRate;
  site.errors->Require(good, Check::kBadFrameRate, "fps",
                       {std::to_string(project.fps.num), std::to_string(project.fps.den)});
  CheckWhole(project.fps.num, "num", site.Field("fps"));
  CheckWhole(project.fps.den, "den", site.Field("fps"));
  CheckFramesOrder(project.frames, site.Field("frames"));
  if (project.preview) CheckFramesOrder(*project.preview, site.Field("preview"));
  const long first = project.frames.first, last = project.frames.last;
  site.errors->Require(last - first < kMostFrames, Check::kTooManyFrames, "frames",
                       {std::to_string(last - first + 1)});
}

// How finely the solver or a region is solved.
template <typename Settings>
void CheckFineness(const Settings& settings, const Site& site) {
  const double step = settings.step_s.value_or(kDefaultStep);
  if (!(step >= kShortestStep && step <= kLongestStep)) {
    site.Field("step_s").Report(Check::kStepRange, {NumberText(step)});
  }
  const double tolerance = settings.tolerance_deg.value_or(kDefaultToleranceDeg);
  if (!(tolerance >= kFinest && tolerance <= kCoarsest)) {
    site.Field("tolerance_deg").Report(Check::kToleranceRange, {NumberText(tolerance)});
  }
}

void CheckSolver(const ProjectSolver& solver, const Site& site) {
  CheckPositive(solver.version, site.Field("version"));
  if (solver.version > kSolverVersion) {
    site.Field("version").Report(Check::kNewerSolver, {std::to_string(solver.version)});
  }
  CheckFineness(solver, site);
}

void CheckOrder(const ProjectKey& before, const ProjectKey& key, const Site& site) {
  if (key.frame == before.frame) site.Report(Check::kKeyTwice, {NumberText(key.frame)});
  if (key.frame < before.frame) {
    site.Report(Check::kKeyOrder, {NumberText(key.frame), NumberText(before.frame)});
  }
}

void CheckKey(const ProjectKey& key, const KeyFieldNames& names, const Site& site) {
  CheckNumber(key.frame, site.Field("frame"));
  CheckNumber(key.value, site.Field(names.value));
  CheckNumber(key.rate.value_or(0.0), site.Field(names.rate));
}

void CheckCurve(const ProjectCurve& curve, const KeyFieldNames& names, const Site& site) {
  for (size_t i = 0; i < curve.keys.size() && site.errors->ok(); ++i) {
    const Site place = site.Field("keys").Item(i);
    CheckKey(curve.keys[i], names, place);
    if (i > 0) CheckOrder(curve.keys[i - 1], curve.keys[i], place.Field("frame"));
  }
}

void CheckCurves(const Project& project, const Site& site) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    CheckCurve(project.root.curves[i], KeyFieldsOf(i),
               site.Field("root").Field(kRootCurveNames[i]));
  }
  for (const auto& joint : project.joints) {
    CheckCurve(joint.value, kAngleKey, site.Field("joints").Field(joint.name));
  }
}

void CheckFactor(double factor, const Site& site) {
  if (factor >= 0.0 && factor <= 1.0) return;
  site.Report(Check::kFactorRange, {NumberText(factor)});
}

void CheckFriction(const ProjectFriction& friction, const Site& site) {
  CheckFactor(friction.default_factor, site.Field("default"));
  for (const auto& joint : friction.joints) {
    CheckFactor(joint.value, site.Field("joints").Field(joint.name));
  }
}

void CheckSpan(int first, int last, const Site& site) {
  CheckWhole(first, "first_frame", site);
  CheckWhole(last, "last_frame", site);
  if (first < last) return;
  site.Report(Check::kSpanEmpty, {std::to_string(first), std::to_string(last)});
}

void CheckRegion(const ProjectRegion& region, const Site& site) {
  CheckNotEmpty(region.name, site.Field("name"));
  CheckSpan(region.first_frame, region.last_frame, site);
  if (region.joints.empty()) site.Field("joints").Report(Check::kRegionEmpty);
  CheckFriction(region.friction, site.Field("friction"));
  CheckFineness(region, site);
  CheckWhole(region.blend_frames, "blend_frames", site);
  if (region.blend_frames >= 0) return;
  site.Field("blend_frames").Report(Check::kNegative, {std::to_string(region.blend_frames)});
}

// Names of one list: none empty, none twice.
template <typename Items>
void CheckNamesUnique(const Items& items, const Site& site) {
  std::map<std::string, std::string> places;
  for (size_t i = 0; i < items.size(); ++i) {
    const Site place = site.Item(i).Field("name");
    CheckNotEmpty(items[i].name, place);
    const auto [it, fresh] = places.emplace(items[i].name, site.Item(i).place);
    if (!fresh) place.Report(Check::kNameTwice, {Quoted(items[i].name), it->second});
  }
}

void CheckShape(const ProjectPlane& plane, const Site& site) {
  CheckUnitVector(plane.normal, site.Field("plane").Field("normal"));
  CheckNumber(plane.offset_m, site.Field("plane").Field("offset_m"));
}
void CheckShape(const ProjectBox& box, const Site& site) {
  CheckPositive(box.size_m, site.Field("box").Field("size_m"));
  CheckNumber(box.size_m, site.Field("box").Field("size_m"));
  CheckNumber(box.center_m, site.Field("box").Field("center_m"));
  CheckNumber(box.rotation_deg, site.Field("box").Field("rotation_deg"));
}
void CheckShape(const ProjectSphereShape& sphere, const Site& site) {
  CheckPositive(sphere.radius_m, site.Field("sphere").Field("radius_m"));
  CheckNumber(sphere.radius_m, site.Field("sphere").Field("radius_m"));
}
void CheckShape(const ProjectBoxShape& box, const Site& site) {
  CheckPositive(box.size_m, site.Field("box").Field("size_m"));
  CheckNumber(box.size_m, site.Field("box").Field("size_m"));
}

// Scene objects and held ones.
template <typename Object>
void CheckObject(const Object& object, const Site& site) {
  std::visit([&](const auto& shape) { CheckShape(shape, site); }, object.shape);
  CheckColor(object.color, site.Field("color"));
  if constexpr (requires { object.mass_kg; }) {
    CheckPositive(object.mass_kg, site.Field("mass_kg"));
    CheckNumber(object.mass_kg, site.Field("mass_kg"));
    CheckWhole(object.release_frame.value_or(0), "release_frame", site);
    CheckNumber(object.offset_m, site.Field("offset_m"));
  }
}

void CheckCamera(const ProjectCamera& camera, const Site& site) {
  const double fov = camera.vertical_fov_deg;
  site.errors->Require(fov >= kNarrowestView && fov <= kWidestView, Check::kFieldOfView,
                       site.Field("vertical_fov_deg").place, {NumberText(fov)});
  CheckNumber(camera.eye_m, site.Field("eye_m"));
  CheckNumber(camera.target_m, site.Field("target_m"));
  if ((camera.eye_m - camera.target_m).norm() < 1e-9) site.Report(Check::kNoView);
}

template <typename Items, typename CheckItem>
void ForEach(const Items& items, const Site& site, CheckItem check) {
  for (size_t i = 0; i < items.size(); ++i) check(items[i], site.Item(i));
}

void CheckScene(const Project& project, const Site& site) {
  CheckNotNegative(project.scene.gravity_m_s2, site.Field("scene").Field("gravity_m_s2"));
  CheckNumber(project.scene.gravity_m_s2, site.Field("scene").Field("gravity_m_s2"));
  const Site objects = site.Field("scene").Field("objects"), held = site.Field("held_objects");
  CheckNamesUnique(project.scene.objects, objects);
  CheckNamesUnique(project.held_objects, held);
  ForEach(project.scene.objects, objects,
          [](const auto& object, const Site& place) { CheckObject(object, place); });
  ForEach(project.held_objects, held,
          [](const auto& object, const Site& place) { CheckObject(object, place); });
  if (project.camera) CheckCamera(*project.camera, site.Field("camera"));
}

}  // namespace

void CheckDocument(const Project& project, FirstError* errors) {
  const Site site{"", errors};
  const auto check_span = [](const auto& span, const Site& place) {
    CheckSpan(span.first_frame, span.last_frame, place);
  };
  CheckTime(project, site);
  CheckSolver(project.solver, site.Field("solver"));
  CheckScene(project, site);
  CheckCurves(project, site);
  CheckNamesUnique(project.regions, site.Field("regions"));
  ForEach(project.regions, site.Field("regions"), CheckRegion);
  ForEach(project.placements, site.Field("placements"), check_span);
  ForEach(project.holds, site.Field("holds"), check_span);
  ForEach(project.markers, site.Field("markers"), [](const auto& marker, const Site& place) {
    CheckNotEmpty(marker.name, place.Field("name"));
    CheckWhole(marker.frame, "frame", place);
  });
}

}  // namespace hazumi
