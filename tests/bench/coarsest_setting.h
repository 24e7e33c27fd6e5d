#pragma once

#include <functional>
#include <optional>

namespace hazumi::bench {

// A setting that makes a method coarser the larger it is: a step [s], or a tolerance [rad].
struct Knob {
  double coarsest, finest;  // that are tried
  // Evaluations of a second; none if it does not survive.
  std::function<std::optional<long>(double setting)> evaluations;

  bool Survives(double setting) const;
};

// None if there is none. By decades, then by bisection to 7 %.
std::optional<double> CoarsestSetting(const Knob& knob);

}  // namespace hazumi::bench
