#include <algorithm>
#include <cmath>

#include "engine/analysis/effort.h"
#include "engine/base/text.h"

namespace hazumi {

namespace {

// The largest of some values, and where it is.
struct Largest {
  double value = 0.0;
  size_t frame = 0;
  int joint = -1;

  void Add(double other, size_t at, int of) {
    if (!(other > value)) return;
    value = other;
    frame = at;
    joint = of;
  }
};

std::string Percent(double share) { return FormatShort(100.0 * share) + " %"; }

struct Peaks {
  Largest torque, share, force, moment;
  size_t least = 0;  // frames in which a strength is the least there is
};

Peaks PeaksOf(const Effort& effort) {
  Peaks peaks;
  for (size_t i = 0; i < effort.frames.size(); ++i) {
    const FrameEffort& frame = effort.frames[i];
    for (int j = 0; j < frame.tau.size(); ++j) {
      peaks.torque.Add(std::abs(frame.tau[j]), i, j);
      peaks.share.Add(frame.share[j], i, j);
    }
    peaks.force.Add(frame.from_nowhere.force.norm(), i, 0);
    peaks.moment.Add(frame.from_nowhere.moment.norm(), i, 0);
    peaks.least += !frame.least.empty();
  }
  return peaks;
}

std::string At(const Motion& motion, const Largest& largest) {
  return " at F" + std::to_string(motion.frames[largest.frame].frame);
}

std::string TorqueLine(const Figure& figure, const Motion& motion, const Effort& effort,
                       const Largest& torque) {
  const FrameEffort& hardest = effort.frames[torque.frame];
  std::string line = "largest torque: " + figure.joints()[torque.joint].name + " " +
                     FormatShort(hardest.tau[torque.joint]) + " N m" + At(motion, torque);
  const double own = hardest.share[torque.joint];
  return own >= 0.0 ? line + ", " + Percent(own) + " of its strength" : line;
}

std::string ShareLine(const Figure& figure, const Motion& motion, const Effort& effort,
                      const Largest& share) {
  return "largest effort: " + figure.joints()[share.joint].name + " " + Percent(share.value) +
         " of its strength, " + FormatShort(effort.frames[share.frame].tau[share.joint]) + " N m" +
         At(motion, share);
}

}  // namespace

std::vector<std::string> BriefEffortReport(const Animation& animation, const Motion& motion,
                                           const Effort& effort) {
  const Peaks peaks = PeaksOf(effort);
  if (peaks.share.joint >= 0) return {ShareLine(*animation.figure, motion, effort, peaks.share)};
  if (peaks.torque.joint < 0) return {};
  return {TorqueLine(*animation.figure, motion, effort, peaks.torque)};
}

std::vector<std::string> EffortReport(const Animation& animation, const Motion& motion,
                                      const Effort& effort) {
  const Figure& figure = *animation.figure;
  const auto& [torque, share, force, moment, least] = PeaksOf(effort);
  std::vector<std::string> lines;
  if (torque.joint < 0) return lines;
  lines.push_back(TorqueLine(figure, motion, effort, torque));
  if (share.joint >= 0) lines.push_back(ShareLine(figure, motion, effort, share));
  const double weight = figure.total_mass() * std::max(animation.gravity, 1.0);
  constexpr double kNoted = 0.01;  // of the weight; of moments, on an arm of a metre
  if (force.value > kNoted * weight || moment.value > kNoted * weight) {
    lines.push_back("from nowhere: " + FormatShort(force.value) + " N" + At(motion, force) + ", " +
                    FormatShort(moment.value) + " N m" + At(motion, moment) +
                    ", which nothing that touches or grips can supply");
  }
  if (least > 0) {
    lines.push_back("in " + std::to_string(least) +
                    " frames a strength is the least there is: joints move faster or farther than "
                    "their muscles were measured");
  }
  if (effort.is_filtered) {
    lines.push_back("a capture: filtered at " + FormatShort(effort.cutoff) +
                    " Hz before it was differentiated");
  }
  return lines;
}

}  // namespace hazumi
