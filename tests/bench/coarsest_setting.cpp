#include "tests/bench/coarsest_setting.h"

#include <cmath>

namespace hazumi::bench {

// By chance a single setting may survive; two somewhat finer ones must do so as well.
bool Knob::Survives(double setting) const {
  for (const double part : {1.0, 0.9, 0.8}) {
    if (!evaluations(part * setting)) return false;
  }
  return true;
}

std::optional<double> CoarsestSetting(const Knob& knob) {
  double good = knob.coarsest;
  while (!knob.Survives(good)) {
    good *= 0.1;
    if (good < 0.99 * knob.finest) return std::nullopt;
  }
  if (good == knob.coarsest) return good;
  double bad = 10.0 * good;
  for (int i = 0; i < 5; ++i) {
    const double middle = std::sqrt(good * bad);
    (knob.Survives(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace hazumi::bench
