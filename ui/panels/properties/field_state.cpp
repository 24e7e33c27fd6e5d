#include "ui/panels/properties/field_state.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

FieldState StateOfField(const ProjectCurve* curve, double frame, double shown, bool is_computed) {
  if (is_computed) return FieldState::kComputed;
  if (!curve || curve->keys.empty()) return FieldState::kPlain;
  const auto key = std::find_if(curve->keys.begin(), curve->keys.end(),
                                [&](const ProjectKey& k) { return k.frame == frame; });
  if (key == curve->keys.end()) return FieldState::kInterpolated;
  constexpr double kSame = 1e-4;  // degrees, of positions metres
  return std::abs(key->value - shown) < kSame ? FieldState::kKeyed : FieldState::kChanged;
}

}  // namespace hazumi::ui
