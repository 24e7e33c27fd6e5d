#pragma once

// The human let go from standing, who falls to the floor in every program.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi::bench {

constexpr double kFallSeconds = 2.0;

// Its region's joints have this friction factor for each 1/30 s [METHOD 2.3].
Animation HumanAboutToFall(double friction);
// As it begins.
MotionLimit StartOfFall(const Animation& fall);

// Of angles [rad]: the worst of hinges, of joints of three hinges as turns, and of the root's turn.
double AngleBetween(const Figure& figure, const MotionLimit& a, const MotionLimit& b);
// The deepest point of the figure's capsules below the floor [m].
double DepthOf(const Figure& figure, const MotionLimit& at);

// What else there is to say of a whole fall.
struct FallAccount {
  double depth = 0.0;  // the greatest [m]
  // Change of energy less the work of joints, limits and floor [J].
  double unaccounted = std::numeric_limits<double>::quiet_NaN();
  double lost = std::numeric_limits<double>::quiet_NaN();  // energy in all [J]
  // Since when contacts come too fast to be followed one by one [s] [METHOD 12.4].
  double time_stepping_from = std::numeric_limits<double>::quiet_NaN();
  bool finished = false;
};

struct FallMethod {
  std::string name;
  std::string unit;                  // of a setting
  std::vector<double> settings;      // from coarse to fine
  double finest, nearly;             // that of its reference, and one beside it
  double usual;                      // the setting of a new file, or the program's default
  std::function<bool(double)> fall;  // all of it, which is timed: whether it got to the end
  // Where the figure is at these frames, 30 a second, as far as it got.
  std::function<std::vector<MotionLimit>(double setting, const std::vector<int>& frames)> states;
  std::function<FallAccount(double setting)> account;
};

// `fall` outlives them.
std::vector<FallMethod> HazumiFalls(const Animation& fall);
std::vector<FallMethod> MujocoFalls(const Animation& fall);

}  // namespace hazumi::bench
