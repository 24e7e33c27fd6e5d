#include "ui/panels/viewport/acting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/filled.h"
#include "engine/project/checks/joint_names.h"
#include "engine/spatial/degrees.h"
#include "ui/panels/viewport/nearest_line.h"

namespace hazumi::ui {

namespace {

constexpr double kOpenGap = 1e-3, kOpenTurn = kDegree;  // less is not seen [m, rad]
// Arrows [m]: so long for each m/s or N s, within bounds; wind ends so far from the figure's
// middle.
constexpr double kOfWind = 0.06, kOfPush = 0.02, kShortest = 0.2, kLongest = 0.8, kAside = 0.45;

hazumi::Pose BodyOf(const std::optional<GroupIndex>& joint, const PosedFigure& figure) {
  return figure.PoseOf(joint ? figure.figure().group(*joint).last() : JointIndex());
}

hazumi::Pose PoseOf(const ConstraintEnd& end, const PosedFigure& figure) {
  const hazumi::Pose own = {end.rotation, end.offset};
  return end.is_in_world ? own : BodyOf(end.joint, figure) * own;
}

bool IsIn(int frame, int first, int last, const Animation& animation) {
  const bool ends_with_all = frame == last && frame == animation.last_frame;
  return frame >= first && (frame < last || ends_with_all);
}

bool IsBroken(const Constraint& constraint, const Motion& motion, int frame) {
  return std::any_of(motion.events.begin(), motion.events.end(), [&](const MotionEvent& event) {
    return event.kind == EventKind::kBreak && event.joint == constraint.name &&
           event.frame <= frame;
  });
}

Vec3 Arrow(const Vec3& value, double scale) {
  const double norm = value.norm();
  if (norm == 0.0) return Vec3::Zero();
  return std::clamp(scale * norm, kShortest, kLongest) / norm * value;
}

// Fills in where it is.
void PlaceMark(const WindForce& wind, const PosedFigure& figure, ForceMark* mark) {
  mark->strength = wind.velocity.norm();
  const Vec3 arrow = Arrow(wind.velocity, kOfWind);
  mark->to = figure.frame().com - kAside * arrow.stableNormalized();
  mark->from = mark->to - arrow;
}
void PlaceMark(const AttractForce& pull, const PosedFigure& figure, ForceMark* mark) {
  mark->from = BodyOf(pull.at.joint, figure) * pull.at.offset;
  mark->to = pull.to;
  const double distance = (mark->to - mark->from).norm();
  mark->strength = pull.force * std::min(distance / pull.radius, 1.0);
}
void PlaceMark(const PushForce& push, const PosedFigure& figure, ForceMark* mark) {
  mark->strength = push.impulse.norm();
  mark->to = BodyOf(push.at.joint, figure) * push.at.offset;
  mark->from = mark->to - Arrow(push.impulse, kOfPush);
}

}  // namespace

bool ConstraintMark::is_open() const { return gap > kOpenGap || turn > kOpenTurn; }

std::vector<ConstraintMark> ConstraintMarks(const Animation& animation, const Motion& motion,
                                            const PosedFigure& figure) {
  std::vector<ConstraintMark> marks;
  const MotionFrame& now = figure.frame();
  for (size_t i = 0; i < animation.constraints.size(); ++i) {
    const Constraint& constraint = animation.constraints[i];
    if (!IsIn(now.frame, constraint.first_frame, constraint.last_frame, animation)) continue;
    const hazumi::Pose X_WA = PoseOf(constraint.a, figure), X_WB = PoseOf(constraint.b, figure);
    ConstraintMark mark;
    mark.index = static_cast<int>(i);
    mark.a = X_WA.p;
    mark.b = X_WB.p;
    const ConstraintGap gap = GapBetween(constraint, X_WA, X_WB);
    mark.gap = gap.distance;
    mark.turn = gap.turn;
    // The motion may be from before an edit, with others.
    if (i < now.constraint_forces.size()) mark.force = now.constraint_forces[i];
    mark.is_broken = IsBroken(constraint, motion, now.frame);
    marks.push_back(mark);
  }
  return marks;
}

std::vector<ForceMark> ForceMarks(const Animation& animation, const PosedFigure& figure) {
  std::vector<ForceMark> marks;
  const int frame = figure.frame().frame;
  for (size_t i = 0; i < animation.forces.size(); ++i) {
    const OuterForce& force = animation.forces[i];
    const bool is_instant = force.kind() == ForceKind::kPush;
    if (is_instant ? frame != force.first_frame
                   : !IsIn(frame, force.first_frame, force.last_frame, animation)) {
      continue;
    }
    ForceMark mark;
    mark.index = static_cast<int>(i);
    mark.kind = force.kind();
    std::visit([&](const auto& action) { PlaceMark(action, figure, &mark); }, force.action);
    marks.push_back(mark);
  }
  return marks;
}

std::string TextOf(const ForceMark& mark) {
  switch (mark.kind) {
    case ForceKind::kWind:
      return Filled("%.1f m/s", mark.strength);
    case ForceKind::kAttract:
      return Filled("%.0f N", mark.strength);
    case ForceKind::kPush:
      break;
  }
  return Filled("%.0f N s", mark.strength);
}

const ConstraintMark* ConstraintAt(const View& view, Point at,
                                   const std::vector<ConstraintMark>& marks, double scale) {
  const auto line = [](const ConstraintMark& mark) { return std::pair(mark.a, mark.b); };
  return NearestLine(view, at, marks, scale, line);
}

const ForceMark* ForceAt(const View& view, Point at, const std::vector<ForceMark>& marks,
                         double scale) {
  return NearestLine(view, at, marks, scale);
}

std::string TextOf(const ConstraintMark& mark, const Project& project) {
  const ProjectConstraint& constraint = project.constraints[mark.index];
  std::string text = constraint.name + ": ";
  if (mark.is_broken) return text + Tr("broken");
  if (!mark.is_open()) return text + Filled("%.0f N", mark.force);
  if (mark.gap > kOpenGap) {
    text += Filled(Tr("%.1f cm apart"), 100.0 * mark.gap);
  } else {
    text += Filled(Tr("turned by %.0f degrees"), mark.turn / kDegree);
  }
  return mark.force > 0.0 ? text + ", " + Filled("%.0f N", mark.force) : text;
}

}  // namespace hazumi::ui
