#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ui/edit/session/session.h"

namespace hazumi::test {

inline constexpr int kJumpTakeOff = 5, kJumpLanding = 25;  // frames on which it still stands

// The new project's figure, which by a key on each frame stands, jumps forward and stands again; in
// the air its arms swing. It flies as it would under a gravity [m/s^2] at the project's frame rate.
inline void KeyJump(double gravity, edit::Session* session) {
  const double fps = 30.0, forward = 0.6;  // [m/s]
  const double x = session->ValueNow("root.x").value(), z = session->ValueNow("root.z").value();
  const double duration = (kJumpLanding - kJumpTakeOff) / fps;
  const auto key = [&](const char* curve, int frame, double value) {
    const Result<Done> done =
        session->Run("key.set", {{"curve", curve}, {"frame", frame}, {"value", value}});
    ASSERT_TRUE(done.ok()) << done.error().ToString();
  };
  for (int frame = 0; frame <= 30; ++frame) {
    const double t = std::clamp((frame - kJumpTakeOff) / fps, 0.0, duration);
    key("root.x", frame, x + forward * t);
    key("root.z", frame, z + 0.5 * gravity * t * (duration - t));
    key("r_shoulder_flexion", frame, 20.0 * std::sin(4.0 * t));
    key("l_shoulder_flexion", frame, 15.0 * std::sin(5.0 * t));
  }
}

}  // namespace hazumi::test
