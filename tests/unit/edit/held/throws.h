#pragma once

// What tests of throws share.

#include <algorithm>
#include <cmath>

#include "tests/unit/edit/sessions.h"

namespace hazumi::test {

// A ball in the right hand, and nothing else.
inline void AddBall(edit::Session* session) {
  Do(session, "held.add_ball", {{"joint", "r_wrist"}});
}

inline edit::Json Onto(const Vec3& spot) {
  return {{"object", "ball"}, {"x", spot.x()}, {"y", spot.y()}, {"z", spot.z()}};
}

inline const Motion& ThrowMotion(edit::Session* session) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return *motion.value();
}

inline Vec3 BallIn(const Motion& motion, int frame) {
  return motion.frames[frame].objects[0].X_WO.p;
}

inline int ReleaseOf(const edit::Session& session) {
  return session.project().held_objects[0].release_frame.value();
}

// When it lies on the spot.
inline int DownAt(const edit::Session& session) {
  return static_cast<int>(session.project().held_objects[0].position.curves[0].keys.back().frame);
}

// Where the parabola through its first two frames of flight is as high as the ball lies.
inline Vec3 LandsAt(const Motion& motion, int release, double height) {
  const double dt = motion.rate.SecondsAt(1), g = 9.81;
  const Vec3 p = BallIn(motion, release);
  const Vec3 v = (BallIn(motion, release + 1) - p) / dt + Vec3(0.0, 0.0, 0.5 * g * dt);
  const double t = (v.z() + std::sqrt(v.z() * v.z() + 2.0 * g * (p.z() - height))) / g;
  return p + t * v - Vec3(0.0, 0.0, 0.5 * g * t * t);
}

// Above where it is let go [m].
inline double RiseOf(const Motion& motion, int release) {
  double highest = 0.0;
  for (int frame = release; frame < static_cast<int>(motion.frames.size()); ++frame) {
    highest = std::max(highest, BallIn(motion, frame).z());
  }
  return highest - BallIn(motion, release).z();
}

}  // namespace hazumi::test
