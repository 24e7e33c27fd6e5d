// How fast the limbs of the region whose bar was clicked are let go: an arrow from where each is on
// the region's first frame to where it would be 0.1 s later at that velocity.

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "engine/base/filled.h"
#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/kinematics.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/start_speed.h"

namespace hazumi::ui {
namespace {

constexpr double kStep = 1e-4;  // [s], to tell a velocity by
constexpr double kArrowSeconds = 0.1;
constexpr double kLeastSpeed = 0.05;  // [m/s]

bool IsBeyond(JointIndex end, const DynamicsRegion& region, const Figure& figure) {
  for (JointIndex j = end; j.is_valid(); j = figure.joint(j).parent) {
    if (std::binary_search(region.joints.begin(), region.joints.end(), j)) return true;
  }
  return region.root;
}

std::vector<Vec3> EndsAt(const MotionFrame& frame, double later, const Figure& figure) {
  const auto& state = frame.after;
  hazumi::Pose X_WR = state.X_WR;
  X_WR.p += later * state.root_v;
  const Vec3 turn = later * state.root_w;
  if (turn.norm() > 0.0) {
    X_WR.R = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * X_WR.R;
  }
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, state.q + later * state.qd, &ws);
  std::vector<Vec3> ends;
  for (const JointIndex end : EndJoints(figure)) ends.push_back(ws.body(end).p);
  return ends;
}

}  // namespace

std::vector<StartSpeed> StartSpeeds(const DynamicsRegion& region, const MotionFrame& start,
                                    const Figure& figure) {
  const std::vector<Vec3> now = EndsAt(start, 0.0, figure), then = EndsAt(start, kStep, figure);
  const std::vector<JointIndex> ends = EndJoints(figure);
  std::vector<StartSpeed> speeds;
  for (size_t i = 0; i < ends.size(); ++i) {
    if (!IsBeyond(ends[i], region, figure)) continue;
    speeds.push_back({ends[i], now[i], (then[i] - now[i]) / kStep});
  }
  return speeds;
}

void DrawStartSpeeds(Editor* editor, const View& view) {
  edit::Session& session = editor->session();
  const std::optional<BarRef> bar = ChosenBar(session.project(), editor->sheet);
  if (!bar || bar->kind != BarKind::kRegion || !session.animation()) return;
  const DynamicsRegion& region = session.animation()->regions[bar->index];
  const Result<const Motion*> motion = session.ShownMotionTo(region.first_frame);
  if (!motion.ok()) return;
  const size_t first = static_cast<size_t>(region.first_frame - editor->first_frame());
  if (first >= motion.value()->frames.size()) return;
  const auto width = static_cast<float>(2.0 * editor->settings.scale);
  const ImU32 color = ToIm(colors::kDynamics);
  for (const StartSpeed& of :
       StartSpeeds(region, motion.value()->frames[first], session.figure())) {
    const auto from = view.ToWindow(of.point);
    const auto to = view.ToWindow(of.point + kArrowSeconds * of.velocity);
    if (!from || !to || of.velocity.norm() < kLeastSpeed) continue;
    DrawArrow(*from, *to, color, width);
    const std::string text = Filled("%.1f m/s", of.velocity.norm());
    DrawShadedText({to->x + 2.0f * width, to->y}, text.c_str());
  }
}

}  // namespace hazumi::ui
