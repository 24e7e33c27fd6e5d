#pragma once

// What tests of jumps share.

#include "engine/dynamics/kinematics.h"
#include "engine/makers/jumps/jumps.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {

inline constexpr double kHigh = 0.5;  // of the box [m]

inline void AddBox(edit::Session* session) {
  Do(session, "object.add_box",
     {{"name", "box"},
      {"x", 1.2},
      {"z", 0.5 * kHigh},
      {"size_x", 0.8},
      {"size_y", 0.8},
      {"size_z", kHigh}});
}

inline Motion JumpMotion(edit::Session* session) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return motion.ok() ? *motion.value() : Motion();
}

inline DynamicsWorkspace Placed(const MotionFrame& frame, edit::Session* session) {
  DynamicsWorkspace ws(session->figure());
  ComputePositions(session->figure(), frame.X_WR, frame.q, &ws);
  return ws;
}

inline Vec3 ToesIn(const MotionFrame& frame, edit::Session* session) {
  const Figure& figure = session->figure();
  const DynamicsWorkspace ws = Placed(frame, session);
  const auto toe = [&](const char* name) {
    return ws.body(figure.group(*figure.FindGroup(name)).first).p;
  };
  return 0.5 * (toe("r_toe") + toe("l_toe"));
}

// By its placements: pinned, flight, pinned.
struct JumpPhases {
  int take_off, landing, end;
};
inline JumpPhases PhasesOf(const edit::Session& session) {
  const std::vector<ProjectPlacement>& spans = session.project().placements;
  EXPECT_EQ(spans.size(), 3u);
  return {spans[0].last_frame, spans[1].last_frame, spans[2].last_frame};
}

}  // namespace hazumi::test
