// The torques that the shown joints need, and what their muscles can give.

#include "ui/panels/graph/torque.h"

#include <algorithm>
#include <cmath>

#include "engine/base/filled.h"
#include "engine/base/text.h"
#include "ui/panels/graph/layout.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

TorqueCurve CurveOf(const EffortWatch& effort, const GraphCurve& of, int index, int first,
                    int last) {
  TorqueCurve curve{index, {}};
  for (int frame = first; frame <= last; ++frame) {
    const FrameEffort* at = effort.At(frame);
    if (at && of.hinge->value() < at->tau.size()) {
      curve.points.emplace_back(frame, at->tau[of.hinge->value()]);
    }
  }
  return curve;
}

// The hinge whose strength is shown.
std::optional<JointIndex> BandOf(const GraphLayout& graph, const std::string& active) {
  std::optional<JointIndex> found;
  for (const GraphCurve& curve : graph.curves) {
    if (!curve.hinge || curve.is_hidden) continue;
    if (curve.name == active) return curve.hinge;
    if (!found) found = curve.hinge;
  }
  return found;
}

std::vector<StrengthBand> BandIn(const Animation& animation, const Motion& motion,
                                 JointIndex hinge) {
  std::vector<StrengthBand> band;
  const std::optional<JointStrength>& strength = animation.figure->joint(hinge).strength;
  if (!strength) return band;
  for (const MotionFrame& frame : motion.frames) {
    const int j = hinge.value();
    if (j >= frame.after.q.size()) continue;  // not computed yet
    const StrengthLimits limits = strength->At(frame.after.q[j], frame.after.qd[j]);
    const double share = MuscleShareAt(animation, hinge, frame.frame);
    band.push_back(
        {1.0 * frame.frame, -share * limits.negative.torque, share * limits.positive.torque});
  }
  return band;
}

// All torques and 0, and of the band as much as leaves the torques large enough to be read.
ValueRange RangeOf(const TorquePanel& panel) {
  constexpr double kMostBand = 4.0, kLeast = 1.0;  // times the largest torque; [N m]
  double low = 0.0, high = 0.0;
  for (const TorqueCurve& curve : panel.curves) {
    for (const auto& [frame, torque] : curve.points) {
      low = std::min(low, torque);
      high = std::max(high, torque);
    }
  }
  const double most = kMostBand * std::max({-low, high, kLeast});
  for (const StrengthBand& at : panel.band) {
    low = std::min(low, std::max(at.low, -most));
    high = std::max(high, std::min(at.high, most));
  }
  const double room = std::max(0.08 * (high - low), 0.1 * kLeast);
  return {low - room, high + room};
}

}  // namespace

float TorquePanel::YOf(double torque) const {
  const double part = (torque - values.low) / (values.high - values.low);
  return rect.bottom() - static_cast<float>(part * rect.h);
}

double MuscleShareAt(const Animation& animation, JointIndex hinge, double frame) {
  for (const DynamicsRegion& region : animation.regions) {
    if (region.is_muted || frame < region.first_frame || frame >= region.last_frame) continue;
    for (const Drive& drive : region.drives) {
      const bool is_its = std::binary_search(drive.joints.begin(), drive.joints.end(), hinge);
      if (is_its && drive.kind == DriveKind::kSpring) return drive.strength.value_or(1.0);
    }
  }
  return 1.0;
}

TorquePanel LayOutTorque(edit::Session* session, const Motion* motion, const EffortWatch& effort,
                         const GraphLayout& graph, const std::string& active, const Rect& rect) {
  TorquePanel panel;
  panel.rect = rect;
  const ProjectFrames& frames = session->project().frames;
  for (size_t i = 0; i < graph.curves.size(); ++i) {
    const GraphCurve& of = graph.curves[i];
    if (!of.hinge || of.is_hidden) continue;
    panel.curves.push_back(CurveOf(effort, of, static_cast<int>(i), frames.first, frames.last));
  }
  panel.band_of = BandOf(graph, active);
  const Animation* animation = session->animation();
  if (panel.band_of && animation && motion) {
    panel.band = BandIn(*animation, *motion, *panel.band_of);
  }
  panel.values = RangeOf(panel);
  return panel;
}

std::string TorqueTextAt(const EffortWatch& effort, const GraphLayout& graph, Point p) {
  const int frame = static_cast<int>(std::lround(graph.frame.axis.FrameAt(p.x)));
  const FrameEffort* at = effort.At(frame);
  std::string text;
  for (const TorqueCurve& curve : graph.torque->curves) {
    const GraphCurve& of = graph.curves[static_cast<size_t>(curve.curve)];
    const int j = of.hinge->value();
    if (!at || j >= at->tau.size()) continue;
    text += (text.empty() ? "" : "\n") + of.name + "   " + Tr("frame") + " " +
            std::to_string(frame) + "   " + FormatShort(at->tau[j]) + " N m";
    if (at->share[j] >= 0.0) {
      text += ", " + Filled(Tr("%.0f %% of its strength"), 100.0 * at->share[j]);
    }
  }
  return text;
}

}  // namespace hazumi::ui
