#include "ui/panels/text/friction_text.h"

#include <cmath>

#include "engine/base/filled.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

// The speed left after t seconds is factor^(30 t).
std::string FrictionInWords(double factor) {
  if (factor <= 0.0) return Tr("Frozen: no speed is left.");
  if (factor >= 1.0) return Tr("No friction: all speed stays.");
  const double half_s = std::log(0.5) / (30.0 * std::log(factor));
  return Filled(Tr("Speed halves in %.2f s; after 1 s %.2g %% is left."), half_s,
                100.0 * std::pow(factor, 30.0));
}

}  // namespace hazumi::ui
