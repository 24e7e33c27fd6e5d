#pragma once

// Animations put together by hand, and what to look for in their motions.

#include <vector>

#include "engine/bake/bake.h"
#include "engine/timeline/animation.h"

namespace hazumi::test {

inline constexpr Interpolation kCubic = Interpolation::kCubic;
inline constexpr double kG = 9.81;  // [m/s^2]

// Frames 0 to 30 at 30 a second, everything at rest and keyed, nothing in the scene.
Animation Still(Figure figure);

JointIndex JointOf(const Animation& animation, const char* name);
GroupIndex GroupOf(const Animation& animation, const char* name);
// The keys of a joint.
Keys& KeysOf(Animation* animation, const char* joint);
// Gives every curve a key on the last frame, that without keys one on the first too, so that after
// a region, a hold or a pin there is somewhere to go.
void KeyTheRest(Animation* animation);
// A region of these joints and all beyond them, with one friction factor.
DynamicsRegion& AddRegion(Animation* animation, const char* name, int first, int last,
                          const std::vector<const char*>& joints, double friction = 1.0);
PlacementSpan& AddPin(Animation* animation, int first, int last, const char* joint);
PlacementSpan& AddGravity(Animation* animation, int first, int last);
IkHold& AddHold(Animation* animation, int first, int last, const char* joint, bool orientation);
void AddFloor(Animation* animation, double height = 0.0);

// Bakes; a failure fails the test.
Motion BakeOrFail(const Animation& animation, const BakeOptions& options = {});
// The error of a bake that must fail.
Error BakeError(const Animation& animation);

// Origin of a joint at a frame [m].
Vec3 OriginOf(const Animation& animation, const MotionFrame& frame, const char* joint);
// Its velocity with the rates of one side of the frame [m/s].
Vec3 VelocityOf(const Animation& animation, const MotionFrame& frame, const MotionLimit& rates,
                const char* joint);
std::vector<MotionEvent> EventsOf(const Motion& motion, EventKind kind);
// Same bits, in angles, rates, root, CoM and objects.
bool IsSame(const MotionFrame& a, const MotionFrame& b);

}  // namespace hazumi::test
