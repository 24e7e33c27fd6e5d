// The flight between is gravity's. With the CoM's heights c0 at take-off and c1 at landing and the
// apex H above c0 it takes
//   T = (sqrt(2 g H) + sqrt(2 g (H - (c1 - c0)))) / g,
// and the stretch to take-off, by h higher, 2 h over the speed there, for the CoM gets to it on a
// parabola of time; the way from the landing to the lowest pose is that backwards. If it flies so
// fast forward that the ground would have to brake it too hard on it, that takes longer, up to 2.8
// h over the speed: the sinking is braked most at first then, and does not turn round.

#include "engine/makers/jumps/jump_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/makers/flights/flights.h"
#include "engine/makers/keyed_moves.h"
#include "engine/placement/contact.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

// The ankle keeps the foot flat where the toes would push off.
void KeepFlat(JumpHinge* ankle) {
  const auto& hip = kJumpHinges[0].angles;
  const auto& knee = kJumpHinges[1].angles;
  for (const JumpPhase phase : {kTakeOff, kStretched}) {
    ankle->angles[phase] = knee[phase] - hip[phase] + kJumpLean[phase];
  }
}

// Without feet the legs alone push off: they are more bent then, or they would have to straighten
// faster than their length can grow.
void PushByTheKnee(JumpHinge* hinge) {
  const std::string_view name = hinge->name;
  if (name != "hip_flexion" && name != "knee") return;
  const bool is_knee = name == "knee";
  hinge->angles[kTakeOff] = is_knee ? 70.0 : 45.0;
  hinge->angles[kStretched] = is_knee ? 25.0 : 15.0;
}

void KeyPlace(const JumpPlan& plan, ProjectRoot* root) {
  for (int i = 0; i < 3; ++i) {
    ProjectCurve& curve = root->curves[kRootX + i];
    RemoveKeysIn(plan.start, plan.end, &curve);
    KeyMove(plan.start, plan.root_before[i], 0.0, &curve);
    for (int phase = 0; phase < kNumJumpPhases; ++phase) {
      if (phase == kStretched || phase == kApex) continue;  // gravity says
      KeyMove(plan.frames[phase], plan.roots[phase][i], {}, &curve);
    }
    KeyMove(plan.end, plan.root_after[i], 0.0, &curve);
  }
}

Result<Done> Pin(int first, int last, ProjectPlacement pin, Project* project) {
  pin.first_frame = first;
  pin.last_frame = last;
  return PutPlacement(std::move(pin), true, &project->placements);
}

}  // namespace

JumpBody::JumpBody(const Figure& figure) {
  const FigureBody body(figure);
  for (size_t i = 0; i < feet.size(); ++i) {
    const std::string side = i == 0 ? "r_" : "l_";
    hips[i] = body.HingeFor(side + "hip_flexion");
    ankles[i] = body.HingeFor(side + "ankle_flexion");
    toes[i] = body.HingeFor(side + "toe");
    feet[i] = StandingJoint(body, i == 0 ? BodySide::kRight : BodySide::kLeft, figure);
  }
  for (const char* hinge : {"hip_abduction", "hip_rotation", "ankle_inversion"}) {
    for (const char* side : {"r_", "l_"}) {
      for (const HingeShare& share : body.HingesFor(side + std::string(hinge))) {
        aside.push_back(share.hinge);
      }
    }
  }
  for (JumpHinge hinge : kJumpHinges) {
    if (!toes[0] && std::string_view(hinge.name) == "ankle_flexion") KeepFlat(&hinge);
    if (!toes[0] && !ankles[0]) PushByTheKnee(&hinge);
    for (const char* side : {"r_", "l_"}) {
      if (!hinge.has_sides && *side == 'l') continue;
      for (const HingeShare& share :
           body.HingesFor((hinge.has_sides ? side : "") + std::string(hinge.name))) {
        AddShare(share, hinge, figure, &hinges);
      }
    }
  }
}

const NamedJumpHinge* JumpBody::Find(JointIndex joint) const {
  const auto found = std::find_if(hinges.begin(), hinges.end(),
                                  [&](const NamedJumpHinge& of) { return of.joint == joint; });
  return found == hinges.end() ? nullptr : &*found;
}

std::optional<Error> JumpBody::Check(const Figure& figure) const {
  return CheckBody({"r_hip_flexion", "r_knee", "l_hip_flexion", "l_knee"}, "jump", figure);
}

Stage::Stage(const Animation& animation, const JumpBody& body)
    : animation_(animation), figure_(*animation.figure), body_(body), ws_(figure_) {
  for (size_t i = 0; i < feet_.size(); ++i) {
    feet_[i] = figure_.group(*figure_.FindGroup(body.feet[i])).first;
  }
}

Result<Vec3> Stage::RootOn(const Stance& stance, const Vec3& spot) {
  constexpr double kAbove = 3.0, kFar = 1000.0;  // [m]
  Place(stance, Vec3::Zero());
  Vec3 root = spot - Toes();
  root.z() = spot.z() + kAbove;
  const auto touch =
      FirstTouchOfFigure(figure_, animation_.scene, ws_, root, Vec3(0.0, 0.0, -kFar));
  if (!touch) return Refusal("x", "there is nothing to stand on; add a ground to the scene");
  root.z() -= *touch * kFar;
  return root;
}

Vec3 Stage::ComOf(const Stance& stance, const Vec3& root) {
  Place(stance, root);
  return CenterOfMass(figure_, ws_);
}

Vec3 Stage::ComOver(const Vec3& toes, const Stance& stance) {
  Place(stance, Vec3::Zero());
  return CenterOfMass(figure_, ws_) + toes - Toes();
}

Vec3 Stage::ToesOf(const Stance& stance, const Vec3& root) {
  Place(stance, root);
  return Toes();
}

std::array<Vec3, 2> Stage::FeetOf(const Stance& stance, const Vec3& root) {
  Place(stance, root);
  return {ws_.body(feet_[0]).p, ws_.body(feet_[1]).p};
}

void Stage::Place(const Stance& stance, const Vec3& root) {
  const Vec3 a = stance.angles * kDegree;
  const Mat3 R = (Eigen::AngleAxisd(a[0], Vec3::UnitZ()) * Eigen::AngleAxisd(a[1], Vec3::UnitY()) *
                  Eigen::AngleAxisd(a[2], Vec3::UnitX()))
                     .toRotationMatrix();
  ComputePositions(figure_, {R, root}, stance.q, &ws_);
}

Vec3 Stage::Toes() const {
  Vec3 middle = Vec3::Zero();
  for (const JointIndex foot : feet_) middle += 0.5 * ws_.body(foot).p;
  return middle;
}

bool StandsOnBothFeet(const Stance& stance, Stage* stage) {
  constexpr double kApart = 0.2, kHigher = 0.08;  // of the height of the hips above the toes
  const auto feet = stage->FeetOf(stance, Vec3::Zero());
  const double yaw = stance.angles[0] * kDegree;
  const Vec3 apart = feet[0] - feet[1], forward(std::cos(yaw), std::sin(yaw), 0.0);
  const double height = std::max(-feet[0].z(), -feet[1].z());
  return std::abs(forward.dot(apart)) < kApart * height && std::abs(apart.z()) < kHigher * height;
}

Result<Done> SetRoots(const JumpSpots& spots, Stage* stage, JumpPlan* plan) {
  constexpr double kFloats = 0.01;  // [m]
  const Result<Vec3> before = stage->RootOn(plan->before, spots.from);
  if (!before.ok()) return before.error();
  // A pin keeps the feet where they are, be it above the ground.
  const double above = plan->root_before.z() - before.value().z();
  const Vec3 lift = (above > kFloats ? above : 0.0) * Vec3::UnitZ();
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    const Result<Vec3> on =
        stage->RootOn(plan->stances[phase], phase <= kTakeOff ? spots.from : spots.onto);
    if (!on.ok()) return on.error();
    plan->roots[phase] = phase <= kTakeOff ? Vec3(on.value() + lift) : on.value();
  }
  const Result<Vec3> after = stage->RootOn(plan->after, spots.onto);
  if (!after.ok()) return after.error();
  plan->root_after = after.value();
  return Done();
}

Result<Done> SetTimes(const Animation& animation, double height, const JumpLengths& lengths,
                      Stage* stage, JumpPlan* plan) {
  constexpr double kBraking = 12.0;  // [m/s^2]
  const double g = animation.gravity;
  const auto height_of = [&](JumpPhase phase) {
    return stage->ComOf(plan->stances[phase], plan->roots[phase]).z();
  };
  const double rise = height_of(kLanding) - height_of(kTakeOff);
  if (!(g > 0.0)) return Refusal("height", "without gravity nothing comes down again");
  if (height <= std::max(0.0, rise)) {
    return Refusal("height", "it lands " + std::to_string(std::lround(100.0 * rise)) +
                                 " cm higher than it takes off: give a greater height");
  }
  const auto frames = [&](double seconds, int least) {
    return FramesOf(seconds, least, animation);
  };
  const double speed = std::sqrt(2.0 * g * height);
  const double up = speed / g, down = std::sqrt(2.0 * (height - rise) / g);
  const double lift = height_of(kTakeOff) - height_of(kCrouch);
  const double sink = height_of(kLanding) - height_of(kAbsorbed);
  const double stretch = std::clamp(2.0 * lift / speed, 0.1, 0.5);
  const Vec3 way = stage->ComOf(plan->stances[kLanding], plan->roots[kLanding]) -
                   stage->ComOf(plan->stances[kTakeOff], plan->roots[kTakeOff]);
  const double braking = way.head<2>().norm() / (up + down) / kBraking;
  const double even = 2.0 * sink / (g * down);
  const double absorb = std::clamp(std::max(even, std::min(braking, 1.4 * even)), 0.1, 0.5);
  JumpFrames& at = plan->frames;
  at[kCrouch] = plan->start + lengths.crouch;
  at[kTakeOff] = at[kCrouch] + frames(stretch, 2);
  at[kLanding] = at[kTakeOff] + frames(up + down, 4);
  at[kStretched] = at[kTakeOff] + frames(kStretchSeconds, 1);
  at[kApex] = std::clamp(at[kTakeOff] + frames(up, 1), at[kStretched] + 1, at[kLanding] - 1);
  at[kAbsorbed] = at[kLanding] + frames(absorb, 2);
  plan->end = at[kAbsorbed] + lengths.rise;
  return Done();
}

bool HasPose(int frame, const JumpBody& body, const Project& project) {
  return std::all_of(body.hinges.begin(), body.hinges.end(), [&](const NamedJumpHinge& of) {
    const ProjectCurve* curve = FindCurve(of.name, project);
    return !of.hinge.bears || (curve && KeyOn(frame, *curve));
  });
}

bool HasContacts(const JumpFrames& frames, const JumpBody& body, const Project& project) {
  const auto says = [&](const std::string& name, JumpPhase phase) {
    const ProjectCurve* curve = FindCurve(name, project);
    const ProjectKey* key = curve ? KeyOn(frames[phase], *curve) : nullptr;
    return key && key->rate;
  };
  const auto says_all = [&](JumpPhase phase) {
    return says(kRootCurveNames[kRootAngleY], phase) &&
           std::all_of(body.hinges.begin(), body.hinges.end(), [&](const NamedJumpHinge& of) {
             return !of.hinge.bears || says(of.name, phase);
           });
  };
  return says_all(kTakeOff) && says_all(kLanding);
}

Result<Done> PutJump(const JumpPlan& plan, JumpPins pins, Project* project) {
  project->frames.last = std::max(project->frames.last, plan.end);
  KeyPlace(plan, &project->root);
  const int take_off = plan.frames[kTakeOff], landing = plan.frames[kLanding];
  Result<Done> put = Pin(plan.start, take_off, std::move(pins.before), project);
  if (!put.ok()) return put;
  Result<MadeFlight> flown = MakeFlight({take_off, landing}, *project);
  if (!flown.ok()) return flown.error();
  *project = std::move(flown.value().project);
  return Pin(landing, plan.end, std::move(pins.after), project);
}

JumpReport ReportOf(const JumpPlan& plan, double height) {
  return {plan.start, plan.frames[kTakeOff], plan.frames[kLanding], plan.end, height};
}

}  // namespace hazumi::makers
