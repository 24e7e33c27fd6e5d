#include <algorithm>
#include <utility>

#include "engine/makers/fills/filled_motion.h"
#include "engine/makers/fills/fills.h"
#include "engine/makers/fills/generated_keys.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kMetersPerDegree = 0.01;  // tolerance of the root's place, by that of angles

void DropEmptyCurves(Project* project) {
  std::erase_if(project->joints, [](const auto& joint) {
    return joint.value.keys.empty() && joint.value.extra.empty();
  });
}

// Visits the curves that a fill may write keys into.
template <typename Visit>
void ForEachCurveOf(const ProjectFill& fill, const Figure& figure, Project* project, Visit visit) {
  if (NameRoot(fill.joints, figure)) {
    for (ProjectCurve& curve : project->root.curves) visit(&curve);
  }
  const std::vector<bool> hinges = JointsOf(fill.joints, figure);
  std::vector<bool> groups(figure.groups().size());
  for (size_t j = 0; j < hinges.size(); ++j) {
    if (hinges[j]) groups[static_cast<size_t>(figure.joints()[j].group.value())] = true;
  }
  for (auto& joint : project->joints) {
    const auto j = figure.FindJoint(joint.name);
    if (j && groups[static_cast<size_t>(figure.joint(*j).group.value())]) visit(&joint.value);
  }
}

// Writes the keys of what was found.
class KeyWriter {
 public:
  KeyWriter(const ProjectFill& fill, const Figure& figure, Project* project, FillReport* report)
      : fill_(fill), figure_(figure), project_(*project), report_(*report) {}

  void Write(const FilledMotion& motion) {
    WritePlace(motion);
    for (const FilledAngles& filled : motion.joints) {
      for (size_t i = 0; i < filled.joint.curves.size(); ++i) {
        if (filled.joint.row[i].is_fixed || filled.joint.keys_of[i]->empty()) continue;
        if (!filled.angles) report_.unfilled.push_back(filled.joint.curves[i]);
        if (filled.angles && filled.joint.has_steps[i]) {
          report_.stepped.push_back(filled.joint.curves[i]);
        }
      }
      if (filled.angles) WriteAngles(filled);
    }
    report_.unfilled.insert(report_.unfilled.end(), motion.unfilled.begin(), motion.unfilled.end());
    report_.farthest = motion.farthest;
    report_.joint = motion.farthest_joint;
    report_.frame = motion.farthest_frame;
  }

 private:
  void WritePlace(const FilledMotion& motion) {
    for (size_t i = 0; i < motion.places.size(); ++i) {
      const FilledPlace& place = motion.places[i];
      if (place.values.empty()) continue;
      report_.keys +=
          PutGeneratedKeys(place.values, place.first, project_.fps,
                           fill_.tolerance_deg * kMetersPerDegree, &project_.root.curves[i]);
    }
  }

  void WriteAngles(const FilledAngles& filled) {
    for (size_t i = 0; i < filled.joint.curves.size(); ++i) {
      if (filled.joint.row[i].is_fixed) continue;
      std::vector<double> values;
      for (const std::vector<double>& angles : filled.angles->by_frame) {
        values.push_back(angles[i] / kDegree);
      }
      const ProjectCurve* there = FindCurve(filled.joint.curves[i], project_);
      if ((!there || there->keys.empty()) && IsStill(values)) continue;
      const Result<ProjectCurve*> curve = CurveNamed(filled.joint.curves[i], figure_, &project_);
      HAZUMI_DEMAND(curve.ok());
      for (const TripleChange& change : filled.angles->changes) {
        PutChange(change, i, curve.value());
      }
      report_.keys += PutGeneratedKeys(values, filled.joint.first, project_.fps,
                                       fill_.tolerance_deg, curve.value());
    }
  }

  // Keys on both sides of the instant in which a ball joint changes its triple of angles: so near
  // to each other that no picture falls between them.
  void PutChange(const TripleChange& change, size_t hinge, ProjectCurve* curve) {
    constexpr double kApart = 0.01;  // [frames]
    const double fps = static_cast<double>(project_.fps.num) / project_.fps.den;
    const auto put = [&](double frame, double angle, double rate, Interpolation interpolation) {
      ProjectKey key;
      key.frame = frame;
      key.value = WithoutRoundOff(angle / kDegree);
      key.rate = WithoutRoundOff(rate / kDegree * fps);
      key.interpolation = interpolation;
      key.type = KeyType::kGenerated;
      PutKey(key, curve);
      ++report_.keys;
    };
    put(change.frame + 0.5 - 0.5 * kApart, change.before[hinge], change.rate_before[hinge],
        Interpolation::kLinear);
    put(change.frame + 0.5 + 0.5 * kApart, change.after[hinge], change.rate_after[hinge],
        Interpolation::kCubic);
  }

  bool IsStill(const std::vector<double>& values) const {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most - *least < fill_.tolerance_deg;
  }

  const ProjectFill& fill_;
  const Figure& figure_;
  Project& project_;
  FillReport& report_;
};

// Parts of a project that its fills depend on.
Project Inputs(const Project& project) {
  Project inputs;
  inputs.fps = project.fps;
  inputs.frames = project.frames;
  inputs.figure = project.figure;
  inputs.root = project.root;
  inputs.joints = project.joints;
  inputs.placements = project.placements;
  inputs.holds = project.holds;
  inputs.fills = project.fills;
  inputs.solver = project.solver;
  inputs.scene = project.scene;
  RemoveGeneratedKeys(&inputs);
  return inputs;
}

}  // namespace

bool HaveSameFills(const Project& a, const Project& b) { return Inputs(a) == Inputs(b); }

bool IsOfFill(const ProjectKey& key, const ProjectFill& fill) {
  return key.type == KeyType::kGenerated && key.frame >= fill.first_frame &&
         key.frame <= fill.last_frame;
}

void RemoveGeneratedKeys(const ProjectFill& fill, const Figure& figure, Project* project) {
  ForEachCurveOf(fill, figure, project, [&](ProjectCurve* curve) {
    std::erase_if(curve->keys, [&](const ProjectKey& key) { return IsOfFill(key, fill); });
  });
  DropEmptyCurves(project);
}

void RemoveGeneratedKeys(Project* project) {
  const auto remove = [](ProjectCurve* curve) {
    std::erase_if(curve->keys, [](const auto& key) { return key.type == KeyType::kGenerated; });
  };
  for (ProjectCurve& curve : project->root.curves) remove(&curve);
  for (auto& joint : project->joints) remove(&joint.value);
  DropEmptyCurves(project);
}

void KeepGeneratedKeys(const ProjectFill& fill, const Figure& figure, Project* project) {
  ForEachCurveOf(fill, figure, project, [&](ProjectCurve* curve) {
    for (ProjectKey& key : curve->keys) {
      if (IsOfFill(key, fill)) key.type = KeyType::kKeyframe;
    }
  });
}

Result<MadeFills> MakeFills(const Project& project, std::shared_ptr<const Figure> figure,
                            const std::atomic<bool>* cancel) {
  MadeFills made{project, {}};
  RemoveGeneratedKeys(&made.project);
  for (const ProjectFill& fill : project.fills) {
    const Result<Compiled> compiled = CompileAnimation(made.project, cancel, figure);
    if (!compiled.ok()) return compiled.error();
    figure = compiled.value().animation.figure;
    Result<FilledMotion> motion = FillMotion(fill, compiled.value().animation, cancel);
    if (!motion.ok()) return motion.error();
    FillReport report;
    KeyWriter(fill, *figure, &made.project, &report).Write(motion.value());
    made.reports.push_back(std::move(report));
  }
  return made;
}

}  // namespace hazumi::makers
