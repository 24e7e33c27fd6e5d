#include "engine/analysis/effort_report.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::vector<std::string> EffortReport(const Animation& animation, const Motion& motion,
                                      const Effort& effort) {
  const auto& joints = animation.figure->joints();
  Largest torque, share, force, moment;
  size_t least = 0;
  for (size_t i = 0; i < effort.frames.size(); ++i) {
    const FrameEffort& frame = effort.frames[i];
    for (int j = 0; j < frame.tau.size(); ++j) {
      torque.Add(std::abs(frame.tau[j]), i, j);
      share.Add(frame.share[j], i, j);
    }
    force.Add(frame.from_nowhere.force.norm(), i, 0);
    moment.Add(frame.from_nowhere.moment.norm(), i, 0);
    least += !frame.least.empty();
  }
  const auto at = [&](const Largest& largest) {
    return " at F" + std::to_string(motion.frames[largest.frame].frame);
  };
  std::vector<std::string> lines;
  if (torque.joint < 0) return lines;
  const FrameEffort& hardest = effort.frames[torque.frame];
  std::string line = "largest torque: " + joints[torque.joint].name + " " +
                     FormatShort(hardest.tau[torque.joint]) + " N m" + at(torque);
  if (const double own = hardest.share[torque.joint]; own >= 0.0) {
    line += ", " + Percent(own) + " of its strength";
  }
  lines.push_back(line);
  if (share.joint >= 0) {
    lines.push_back("largest effort: " + joints[share.joint].name + " " + Percent(share.value) +
                    " of its strength, " +
                    FormatShort(effort.frames[share.frame].tau[share.joint]) + " N m" + at(share));
  }
  const double weight = animation.figure->total_mass() * std::max(animation.gravity, 1.0);
  constexpr double kNoted = 0.01;  // of the weight; of moments, on an arm of a metre
  if (force.value > kNoted * weight || moment.value > kNoted * weight) {
    lines.push_back("from nowhere: " + FormatShort(force.value) + " N" + at(force) + ", " +
                    FormatShort(moment.value) + " N m" + at(moment) +
                    ", which neither ground nor pin can supply");
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
  if (!animation.forces.empty()) {
    lines.push_back("forces from outside are not taken off: what they do counts as from nowhere");
  }
  return lines;
}

}  // namespace hazumi
