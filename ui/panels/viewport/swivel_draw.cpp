#include <cmath>
#include <numbers>

#include "ui/panels/viewport/swivel_handle.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// The circle on which the elbow goes, and a ring around the elbow.
void DrawSwivelHandle(const Editor& editor, const View& view, const SwivelHandle& handle) {
  constexpr int kPoints = 48;
  const auto scale = static_cast<float>(editor.settings.scale);
  const Vec3 u = handle.at - handle.center, v = handle.axis.cross(u);
  for (int i = 0; i < kPoints; ++i) {
    const auto at = [&](int k) {
      const double t = 2.0 * std::numbers::pi * k / kPoints;
      return view.ToWindow(handle.center + std::cos(t) * u + std::sin(t) * v);
    };
    const auto from = at(i), to = at(i + 1);
    if (!from || !to || i % 2 != 0) continue;
    Canvas()->AddLine(ToIm(*from), ToIm(*to), ToIm(colors::kWhite, 0.6f), 1.5f * scale);
  }
  const std::optional<Point> elbow = view.ToWindow(handle.at);
  if (!elbow) return;
  Canvas()->AddCircle(ToIm(*elbow), 7.0f * scale, ToIm(colors::kShade, 0.8f), 24, 4.0f * scale);
  Canvas()->AddCircle(ToIm(*elbow), 7.0f * scale, ToIm(colors::kSelected), 24, 2.0f * scale);
}

}  // namespace hazumi::ui
