// Which curves the graph shows, and how they run.

#include "ui/panels/graph/curves.h"

#include <algorithm>
#include <cmath>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "engine/spatial/degrees.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::ui {

namespace {

// A curve's value and rate on one side of a frame, in the units of the document.
struct Limit {
  double value = 0.0, rate = 0.0;
};

Limit RootLimit(const MotionLimit& at, int root_curve) {
  const Mat3& R = at.X_WR.R;
  switch (root_curve) {
    case kRootX:
    case kRootY:
    case kRootZ:
      return {at.X_WR.p[root_curve], at.root_v[root_curve]};
    case kRootAngleZ:
      return {std::atan2(R(1, 0), R(0, 0)) / kDegree, 0.0};
    case kRootAngleY:
      return {std::asin(std::clamp(-R(2, 0), -1.0, 1.0)) / kDegree, 0.0};
    default:
      return {std::atan2(R(2, 1), R(2, 2)) / kDegree, 0.0};
  }
}

Limit LimitOf(const MotionLimit& at, const GraphCurve& curve) {
  if (!curve.hinge) return RootLimit(at, curve.root_curve);
  const int j = curve.hinge->value();
  return {at.q[j] / kDegree, at.qd[j] / kDegree};
}

// Of an object, from frame i to the next: straight.
Limit ObjectLimit(const Motion& motion, size_t i, bool is_before, const ObjectCurve& curve) {
  const auto at = [&](size_t frame) {
    const std::vector<ObjectPose>& objects = motion.frames[frame].objects;
    return curve.object < objects.size() ? objects[curve.object].X_WO.p[curve.axis] : 0.0;
  };
  const size_t from = is_before && i > 0 ? i - 1 : i;
  const size_t to = std::min(from + 1, motion.frames.size() - 1);
  return {at(i), (at(to) - at(from)) * motion.rate.FrameAt(1.0)};
}

// On the left or right side of frame i of the motion.
Limit LimitAt(const Motion& motion, size_t i, bool is_before, const GraphCurve& curve) {
  if (curve.object) return ObjectLimit(motion, i, is_before, *curve.object);
  const MotionFrame& frame = motion.frames[i];
  return LimitOf(is_before ? frame.before : frame.after, curve);
}

// The root's angles have no rates here: straight lines join them.
bool IsStraight(const GraphCurve& curve) {
  return !curve.hinge && !curve.object && curve.root_curve >= kRootAngleZ;
}

// Between two frames: the cubic with the values and rates at both.
double Between(const Limit& a, const Limit& b, double seconds, double s) {
  const double d = b.value - a.value, m0 = a.rate * seconds, m1 = b.rate * seconds;
  return a.value + s * (m0 + s * (3.0 * d - 2.0 * m0 - m1 + s * (m0 + m1 - 2.0 * d)));
}

// Frames in which regions drive a curve: half open.
std::vector<std::pair<int, int>> ComputedSpans(const edit::Session& session,
                                               const GraphCurve& curve) {
  std::vector<std::pair<int, int>> spans;
  for (const ProjectRegion& region : session.project().regions) {
    const bool drives = curve.hinge ? JointsOf(region, session.figure())[curve.hinge->value()]
                                    : IsStraight(curve) && DrivesRoot(region, session.figure());
    if (drives) spans.emplace_back(region.first_frame, region.last_frame);
  }
  return spans;
}

// An angle of the root is known but for whole turns [degrees].
double NearTo(double other, double angle) {
  return angle + 360.0 * std::round((other - angle) / 360.0);
}

// The value of a curve's first key.
double FirstKey(const edit::Session& session, const GraphCurve& curve) {
  const ProjectCurve* keyed = FindCurve(curve.name, session.project());
  return keyed && !keyed->keys.empty() ? keyed->keys.front().value : 0.0;
}

}  // namespace

std::vector<std::string> ShownCurves(const edit::Session& session, const SheetState& state) {
  std::vector<std::string> names;
  const KeySelection& keys = session.selected_keys();
  for (const Joint& joint : session.figure().joints()) {
    if (session.selected_joints().contains(joint.name)) names.push_back(joint.name);
  }
  if (session.is_root_selected()) {
    names.insert(names.end(), std::begin(kRootCurveNames), std::end(kRootCurveNames));
  }
  if (!names.empty()) return names;
  for (const std::string& name : CurveNames(session.project())) {
    if (keys.contains(name)) names.push_back(name);
  }
  // What is shown stays as long as that has the keys that are selected.
  const bool are_shown = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::count(state.curves.begin(), state.curves.end(), name) > 0;
  });
  if (!are_shown) return names;
  names = state.curves;
  std::erase_if(names, [&](const std::string& name) {
    return !RootCurveNamed(name) && !session.figure().FindJoint(name) &&
           !ObjectCurveNamed(name, session.project());
  });
  return names;
}

GraphCurve CurveFor(const edit::Session& session, const std::string& name) {
  GraphCurve curve;
  curve.name = name;
  curve.hinge = session.figure().FindJoint(name);
  const std::vector<std::string> all = CurveNames(session.project());
  const auto found = std::find(all.begin(), all.end(), name);
  curve.object = ObjectCurveNamed(name, session.project());
  if (!curve.hinge && !curve.object) curve.root_curve = static_cast<int>(found - all.begin());
  return curve;
}

void SampleCurve(const edit::Session& session, const Motion& motion, const TimeAxis& axis,
                 GraphCurve* curve) {
  const double seconds = motion.rate.SecondsAt(1.0);
  constexpr double kPointPx = 4.0;
  const int steps = std::clamp(static_cast<int>(axis.px_per_frame() / kPointPx), 1, 12);
  const std::vector<std::pair<int, int>> spans = ComputedSpans(session, *curve);
  double last = FirstKey(session, *curve);
  for (size_t i = 0; i + 1 < motion.frames.size(); ++i) {
    const MotionFrame& frame = motion.frames[i];
    Limit a = LimitAt(motion, i, false, *curve);
    Limit b = LimitAt(motion, i + 1, true, *curve);
    if (IsStraight(*curve)) {
      a.value = last = NearTo(last, a.value);
      b.value = last = NearTo(last, b.value);
    }
    const bool is_computed = std::any_of(spans.begin(), spans.end(), [&](const auto& span) {
      return frame.frame >= span.first && frame.frame < span.second;
    });
    // A jump between the two sides of a frame is a line too.
    if (!curve->points.empty()) curve->is_computed.push_back(false);
    const bool is_seen = frame.frame + 1.0 >= axis.first && frame.frame <= axis.last;
    const int parts = IsStraight(*curve) || !is_seen ? 1 : steps;
    for (int k = 0; k <= parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      curve->points.emplace_back(frame.frame + s, Between(a, b, seconds, s));
      if (k > 0) curve->is_computed.push_back(is_computed);
    }
  }
}

void RatesAt(const Motion& motion, const GraphCurve& curve, GraphKey* key) {
  if (motion.frames.empty()) return;
  const int i = static_cast<int>(std::lround(key->frame)) - motion.frames.front().frame;
  if (i < 0 || i >= static_cast<int>(motion.frames.size())) return;
  key->rate_before = LimitAt(motion, i, true, curve).rate;
  key->rate = LimitAt(motion, i, false, curve).rate;
}

}  // namespace hazumi::ui
