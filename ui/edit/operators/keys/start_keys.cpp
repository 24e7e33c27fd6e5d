#include "ui/edit/operators/keys/start_keys.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/keys.h"
#include "engine/timeline/curve_track.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {
namespace {

// First frames of the other regions for which `is_of` is true.
template <typename IsOf>
std::vector<double> StartsOf(const Project& project, const ProjectRegion& own, const IsOf& is_of) {
  std::vector<double> starts;
  for (const ProjectRegion& other : project.regions) {
    if (&other != &own && !other.mute && is_of(other)) starts.push_back(other.first_frame);
  }
  return starts;
}

// Puts a key where the curve is. The automatic tangent of the key before would see the new one as
// its neighbour, so its rate is said.
void KeyAsItRuns(int frame, const ProjectRate& fps, double rest, const std::vector<double>& starts,
                 ProjectCurve* curve) {
  const FrameRate rate{fps.num, fps.den};
  ToCubicsAround(frame, fps, curve);
  auto before = std::lower_bound(curve->keys.begin(), curve->keys.end(), frame,
                                 [](const ProjectKey& key, int f) { return key.frame < f; });
  if (before != curve->keys.end() && before->frame == frame) return;
  const bool has_before = before != curve->keys.begin();
  if (has_before) --before;
  const bool is_moved = std::any_of(starts.begin(), starts.end(), [&](double start) {
    return start < frame && (!has_before || start >= before->frame);
  });
  if (is_moved) return;
  const Keys keys = ToKeys(*curve, 1.0);
  CurveTrack track(&keys, rate, rest, starts);
  const CurveSample at = track.Before(frame);
  if (has_before && before != curve->keys.begin() && !before->rate &&
      !IsEased(before->interpolation)) {
    before->rate = WithoutRoundOff(track.Before(before->frame).rate);
  }
  ProjectKey key;
  key.frame = frame;
  key.value = WithoutRoundOff(at.value);
  key.rate = WithoutRoundOff(at.rate);
  if (has_before) key.interpolation = before->interpolation;
  PutKey(key, curve);
}

}  // namespace

void KeyRegionStart(const ProjectRegion& region, const Figure& figure, Project* project) {
  const ProjectRate& rate = project->fps;
  const std::vector<bool> moved = JointsOf(region, figure);
  for (int j = 0; j < figure.num_joints(); ++j) {
    const Joint& joint = figure.joints()[j];
    if (!moved[j] || joint.is_fixed()) continue;
    const auto moves = [&](const ProjectRegion& other) {
      return static_cast<bool>(JointsOf(other, figure)[j]);
    };
    ProjectCurve* curve = CurveNamed(joint.name, figure, project).value();
    KeyAsItRuns(region.first_frame, rate, joint.rest / kDegree, StartsOf(*project, region, moves),
                curve);
  }
  const auto turns = [&](const ProjectRegion& other) { return DrivesRoot(other, figure); };
  for (int i = kRootAngleZ; i < kNumRootCurves && turns(region); ++i) {
    KeyAsItRuns(region.first_frame, rate, 0.0, StartsOf(*project, region, turns),
                &project->root.curves[i]);
  }
}

}  // namespace hazumi::edit
