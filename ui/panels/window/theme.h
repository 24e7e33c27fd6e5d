#pragma once

#include "render/scene/color.h"

namespace hazumi::ui {

using render::SrgbColor;

// Colours with a meaning, the same in both themes. Never alone: a shape or a text goes with each.
namespace colors {
inline constexpr SrgbColor kWhite = render::FromHex(0xffffff);
inline constexpr SrgbColor kShade = render::FromHex(0x16181b);  // behind what is white
inline constexpr SrgbColor kKeyed = render::FromHex(0xb3ae36);
inline constexpr SrgbColor kInterpolated = render::FromHex(0x53992e);
inline constexpr SrgbColor kChanged = render::FromHex(0xcc7529);
inline constexpr SrgbColor kDynamics = render::FromHex(0x2f8fff);  // computed by a region: hatched
inline constexpr SrgbColor kMuscle = render::FromHex(0xc4504a);    // how strong a spring is
inline constexpr SrgbColor kHeld = render::FromHex(0xa06fd6);      // a joint, by a hold
inline constexpr SrgbColor kOuterForce = render::FromHex(0x1fb8a6);  // wind, pulls, pushes
inline constexpr SrgbColor kSinking = render::FromHex(0xe0364f);     // into the ground
inline constexpr SrgbColor kKey = render::FromHex(0xbfbfbf);
inline constexpr SrgbColor kBreakdown = render::FromHex(0x4fa3d9);
inline constexpr SrgbColor kExtreme = render::FromHex(0xe0708c);
inline constexpr SrgbColor kJitter = render::FromHex(0x5fbf5a);
inline constexpr SrgbColor kMovingHold = render::FromHex(0x6a6a6a);
inline constexpr SrgbColor kGenerated = render::FromHex(0x3fb58c);  // by a fill
inline constexpr SrgbColor kGoal = render::FromHex(0xf08cd0);       // what is to come true
inline constexpr SrgbColor kSelected = render::FromHex(0xffbe33);
inline constexpr SrgbColor kAxisX = render::FromHex(0xff3352);
inline constexpr SrgbColor kAxisY = render::FromHex(0x8bdc00);
inline constexpr SrgbColor kAxisZ = render::FromHex(0x2890ff);
}  // namespace colors

// Colours of the surfaces.
struct Theme {
  SrgbColor window, panel, header, field, field_hovered, line, text, faint_text, accent, row,
      row_odd, heading, warning;
  SrgbColor playhead = render::FromHex(0x4f8fdc);
};
const Theme& DarkTheme();
const Theme& LightTheme();

}  // namespace hazumi::ui
