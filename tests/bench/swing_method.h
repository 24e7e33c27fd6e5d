#pragma once

// A way to compute how an arm left to itself swings, at a choice of settings that trade time for
// accuracy.

#include <functional>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/types.h"

namespace hazumi::bench {

struct SwingCase {
  std::string name;
  VecX q, qd;  // at the start [rad, rad/s]
  double seconds;
  VecX friction;          // factor per 1/30 s
  VecX lower, upper;      // [rad]
  bool is_free = true;    // neither friction nor limits
  bool singular = false;  // the shoulder's hinges nearly line up at the start
  // How wrong the end angles are [rad], and the error of the reference itself.
  std::function<double(const VecX& q_end)> error;
  double reference_error;
};

struct SwingMethod {
  std::string name;
  std::string unit;              // what a setting counts, e.g. "steps"
  std::vector<double> settings;  // from coarse to fine
  std::function<bool(const SwingCase&)> handles;
  // From the start of the case to its end: the timed call. Returns the seven end angles [rad].
  std::function<VecX(const SwingCase&, double setting)> run;
  // From the arm to whatever run() has ready before the first case: timed apart.
  std::function<void(const SwingCase&)> set_up;
};

// Conditions for SwingMethod::handles.
inline bool FreeWithHinges(const SwingCase& c) { return c.is_free && !c.singular; }
inline bool FreeNearSingularity(const SwingCase& c) { return c.is_free && c.singular; }

// `count` numbers from `first`, each `ratio` times the one before.
std::vector<double> GeometricSettings(double first, double ratio, int count);

// All on the arm of the test figures; it outlives the methods.
std::vector<SwingMethod> HazumiMethods(const Figure& arm);
std::vector<SwingMethod> MujocoMethods(const Figure& arm);
std::vector<SwingMethod> SimbodyMethods(const Figure& arm);
std::vector<SwingMethod> BulletMethods(const Figure& arm);
std::vector<SwingMethod> DartMethods(const Figure& arm);

}  // namespace hazumi::bench
