// A jump from where the figure stands onto a spot, as ordinary keys: crouch, take-off, apex,
// landing, and back to how it stood. The feet are pinned until take-off and after the landing; the
// flight between is gravity's. With the CoM's heights c0 at take-off and c1 at landing and the apex
// H above c0 the flight takes
//   T = (sqrt(2 g H) + sqrt(2 g (H - (c1 - c0)))) / g,
// and the stretch to take-off so long that the CoM leaves the crouch, on a parabola of the angles,
// as fast as the flight begins.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/keys/keyed_moves.h"
#include "ui/edit/operators/placement/flight_plan.h"
#include "ui/edit/operators/placement/jump_poses.h"
#include "ui/edit/operators/placement/root_curves.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

constexpr const char* kToes[] = {"r_toe", "l_toe"};
constexpr double kCrouchSeconds = 0.4, kAbsorbSeconds = 0.2, kRiseSeconds = 0.6;
constexpr double kStretchSeconds = 0.07;  // of going on to stretch after take-off

// A pose by hinge and the root's orientation.
struct Stance {
  VecX q;       // [rad]
  Vec3 angles;  // of the root: z, y, x [degrees]
};

// Stances of a figure, put onto the scene.
class Stage {
 public:
  explicit Stage(const Animation& animation)
      : animation_(animation), figure_(*animation.figure), ws_(figure_) {}

  // Where the root is if the middle of the toes is above `spot` and the figure, come down from
  // above, touches the scene. Errors: kSchema if there is nothing to stand on.
  Result<Vec3> RootOn(const Stance& stance, const Vec3& spot) {
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
  Vec3 ComOf(const Stance& stance, const Vec3& root) {
    Place(stance, root);
    return CenterOfMass(figure_, ws_);
  }
  Vec3 ToesOf(const Stance& stance, const Vec3& root) {
    Place(stance, root);
    return Toes();
  }

 private:
  void Place(const Stance& stance, const Vec3& root) {
    const Vec3 a = stance.angles * kDegree;
    const Mat3 R = (Eigen::AngleAxisd(a[0], Vec3::UnitZ()) *
                    Eigen::AngleAxisd(a[1], Vec3::UnitY()) * Eigen::AngleAxisd(a[2], Vec3::UnitX()))
                       .toRotationMatrix();
    ComputePositions(figure_, {R, root}, stance.q, &ws_);
  }
  Vec3 Toes() const {
    Vec3 middle = Vec3::Zero();
    for (const char* toe : kToes) {
      middle += 0.5 * ws_.body(figure_.group(*figure_.FindGroup(toe)).first).p;
    }
    return middle;
  }

  const Animation& animation_;
  const Figure& figure_;
  DynamicsWorkspace ws_;
};

// Every hinge that a jump keys, with its angles.
std::vector<std::pair<std::string, const JumpHinge*>> HingesOfJump() {
  std::vector<std::pair<std::string, const JumpHinge*>> all;
  for (const JumpHinge& hinge : kJumpHinges) {
    if (!hinge.has_sides) all.emplace_back(hinge.name, &hinge);
    for (const char* side : {"r_", "l_"}) {
      if (hinge.has_sides) all.emplace_back(side + std::string(hinge.name), &hinge);
    }
  }
  return all;
}

std::optional<Error> CheckFigure(const Figure& figure) {
  std::vector<std::string> names;
  for (const auto& [name, hinge] : HingesOfJump()) names.push_back(name);
  return CheckHinges(names, "jump", figure);
}

Stance StanceOf(JumpPhase phase, const Stance& start, const Figure& figure) {
  Stance stance = start;
  for (const auto& [name, hinge] : HingesOfJump()) {
    stance.q[figure.FindJoint(name)->value()] = hinge->angles[phase] * kDegree;
  }
  stance.angles[1] = kJumpLean[phase];
  return stance;
}

Stance Between(const Stance& a, const Stance& b, double s) {
  return {a.q + s * (b.q - a.q), a.angles + s * (b.angles - a.angles)};
}

// Which frame each phase is on, and where the root is.
struct JumpPlan {
  int start = 0, end = 0;
  std::array<int, kNumJumpPhases> frames{};
  std::array<Stance, kNumJumpPhases> stances;
  std::array<Vec3, kNumJumpPhases> roots;
  Stance standing;
  Vec3 root_before, root_after;  // where it stands
  double stretch = 0.0;          // from crouch to take-off [s]
};

// How fast the CoM rises at take-off per second of a stretch that takes one second, on a parabola.
double RiseAtTakeOff(const JumpPlan& plan, const Vec3& spot, Stage* stage) {
  constexpr double kStep = 0.02;
  const auto height = [&](double s) {
    const Stance stance = Between(plan.stances[kCrouch], plan.stances[kTakeOff], s);
    const Result<Vec3> root = stage->RootOn(stance, spot);
    return root.ok() ? stage->ComOf(stance, root.value()).z() : 0.0;
  };
  return 2.0 * (height(1.0) - height(1.0 - kStep)) / kStep;
}

// The frames, for an apex so high above take-off [m].
Result<Done> SetTimes(const Animation& animation, double height, const Vec3& spot, Stage* stage,
                      JumpPlan* plan) {
  const double g = animation.gravity, fps = animation.rate.FrameAt(1.0);
  const double rise = stage->ComOf(plan->stances[kLanding], plan->roots[kLanding]).z() -
                      stage->ComOf(plan->stances[kTakeOff], plan->roots[kTakeOff]).z();
  if (!(g > 0.0)) return Refusal("height", "without gravity nothing comes down again");
  if (height <= std::max(0.0, rise)) {
    return Refusal("height", "it lands " + std::to_string(std::lround(100.0 * rise)) +
                                 " cm higher than it takes off: let it jump higher");
  }
  const auto frames = [&](double seconds, int least) {
    return FramesOf(seconds, least, animation);
  };
  const double speed = std::sqrt(2.0 * g * height);
  const double up = speed / g, down = std::sqrt(2.0 * (height - rise) / g);
  const double stretch = std::clamp(RiseAtTakeOff(*plan, spot, stage) / speed, 0.1, 0.5);
  std::array<int, kNumJumpPhases>& at = plan->frames;
  at[kCrouch] = plan->start + frames(kCrouchSeconds, 2);
  at[kTakeOff] = at[kCrouch] + frames(stretch, 2);
  plan->stretch = (at[kTakeOff] - at[kCrouch]) / fps;
  at[kLanding] = at[kTakeOff] + frames(up + down, 4);
  at[kStretched] = at[kTakeOff] + frames(kStretchSeconds, 1);
  at[kApex] = std::clamp(at[kTakeOff] + frames(up, 1), at[kStretched] + 1, at[kLanding] - 1);
  at[kAbsorbed] = at[kLanding] + frames(kAbsorbSeconds, 2);
  plan->end = at[kAbsorbed] + frames(kRiseSeconds, 3);
  return Done();
}

Result<JumpPlan> PlanJump(const Animation& animation, const MotionFrame& now, int frame,
                          const Vec3& target, double height, const ProjectRoot& root) {
  const Figure& figure = *animation.figure;
  Stage stage(animation);
  JumpPlan plan;
  plan.start = frame;
  const auto values = RootValues(now.X_WR, root, frame);
  plan.standing = {now.q, Vec3(values[kRootAngleZ], values[kRootAngleY], values[kRootAngleX])};
  const Vec3 spot = stage.ToesOf(plan.standing, now.X_WR.p);
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    plan.stances[phase] = StanceOf(static_cast<JumpPhase>(phase), plan.standing, figure);
    const bool is_before = phase <= kTakeOff;
    const Result<Vec3> on = stage.RootOn(plan.stances[phase], is_before ? spot : target);
    if (!on.ok()) return on.error();
    plan.roots[phase] = on.value();
  }
  const Result<Vec3> after = stage.RootOn(plan.standing, target);
  if (!after.ok()) return after.error();
  plan.root_before = now.X_WR.p;
  plan.root_after = after.value();
  const Result<Done> timed = SetTimes(animation, height, spot, &stage, &plan);
  if (!timed.ok()) return timed.error();
  return plan;
}

// Where it pushes off the stretch is a parabola of the angle, which ends as fast as it goes.
void KeyHinge(const JumpPlan& plan, int hinge, bool pushes_off, ProjectCurve* curve) {
  const auto angle = [&](const Stance& stance) { return stance.q[hinge] / kDegree; };
  RemoveKeysIn(plan.start, plan.end, curve);
  KeyMove(plan.start, angle(plan.standing), 0.0, curve);
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    std::optional<double> rate;
    const double now = angle(plan.stances[phase]);
    if (phase == kCrouch) rate = 0.0;
    if (phase == kTakeOff && pushes_off)
      rate = 2.0 * (now - angle(plan.stances[kCrouch])) / plan.stretch;
    KeyMove(plan.frames[phase], now, rate, curve);
  }
  KeyMove(plan.end, angle(plan.standing), 0.0, curve);
}

void KeyRoot(const JumpPlan& plan, ProjectRoot* root) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    ProjectCurve& curve = root->curves[i];
    const bool is_angle = i >= kRootAngleZ;
    const auto value = [&](const Stance& stance, const Vec3& at) {
      return is_angle ? stance.angles[i - kRootAngleZ] : at[i];
    };
    RemoveKeysIn(plan.start, plan.end, &curve);
    KeyMove(plan.start, value(plan.standing, plan.root_before), 0.0, &curve);
    for (int phase = 0; phase < kNumJumpPhases; ++phase) {
      const bool flies = phase == kStretched || phase == kApex;
      if (flies && !is_angle) continue;  // gravity says
      KeyMove(plan.frames[phase], value(plan.stances[phase], plan.roots[phase]), {}, &curve);
    }
    KeyMove(plan.end, value(plan.standing, plan.root_after), 0.0, &curve);
  }
}

Result<Done> Pin(int first, int last, ProjectPlacement* pin, Project* project) {
  pin->kind = PlacementKind::kPinned;
  pin->pin = kToes[0];
  pin->first_frame = first;
  pin->last_frame = last;
  return PutPlacement(*pin, true, &project->placements);
}

// Nothing else may move what the jump moves.
std::optional<Error> CheckFree(const JumpPlan& plan, const Project& project) {
  for (const ProjectPlacement& span : project.placements) {
    const bool is_in_way = span.first_frame < plan.end && span.last_frame > plan.start;
    if (span.kind == PlacementKind::kKeyed || !is_in_way) continue;
    return Refusal("", "frames " + std::to_string(span.first_frame) + " to " +
                           std::to_string(span.last_frame) +
                           " are placed by a pin or by gravity already; jump after them");
  }
  return CheckFreeOfRegions(plan.start, plan.end, "jump before or after it", project);
}

Result<Done> KeyJump(const JumpPlan& plan, const Figure& figure, Project* project) {
  if (const auto error = CheckFree(plan, *project)) return *error;
  project->frames.last = std::max(project->frames.last, plan.end);
  for (const auto& [name, hinge] : HingesOfJump()) {
    const Result<ProjectCurve*> curve = CurveNamed(name, figure, project);
    if (!curve.ok()) return curve.error();
    KeyHinge(plan, figure.FindJoint(name)->value(), hinge->pushes_off, curve.value());
  }
  KeyRoot(plan, &project->root);
  const int take_off = plan.frames[kTakeOff], landing = plan.frames[kLanding];
  ProjectPlacement pin;
  if (Result<Done> before = Pin(plan.start, take_off, &pin, project); !before.ok()) return before;
  Result<Done> flown = FlyByGravity({take_off, landing}, project);
  if (!flown.ok()) return flown;
  ProjectPlacement after;
  return Pin(landing, plan.end, &after, project);
}

// Not given how high: as little as it takes to get there.
Result<Done> AddJump(Session* session, const Parameters& p) {
  constexpr double kLeast = 0.15, kMost = 1.5, kStep = 0.05;  // [m]
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Figure& figure = session->figure();
  if (const auto error = CheckFigure(figure)) return *error;
  const int frame = static_cast<int>(std::lround(session->frame()));
  const Vec3 ahead = now.value()->X_WR.p + now.value()->X_WR.R * Vec3(0.8, 0.0, 0.0);
  const Vec3 target(p.number("x", ahead.x()), p.number("y", ahead.y()), 0.0);
  const auto jump = [&](double height, Project* project) -> Result<Done> {
    const Result<JumpPlan> plan = PlanJump(*session->animation(), *now.value(), frame, target,
                                           height, session->project().root);
    if (!plan.ok()) return plan.error();
    return KeyJump(plan.value(), figure, project);
  };
  return session->Edit(
      "Add jump",
      [&](Project* project) -> Result<Done> {
        if (p.has("height")) return jump(p.number("height"), project);
        Result<Done> done = Done();
        for (double height = kLeast; height <= kMost; height += kStep) {
          Project tried = *project;
          done = jump(height, &tried);
          if (!done.ok()) continue;
          *project = std::move(tried);
          return done;
        }
        return done;
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> JumpOperators() {
  return {{"jump.add",
           "Add jump",
           "Keys a jump from where the figure stands in the current frame onto a spot: crouch, "
           "take-off, apex and landing. Not given: 80 cm ahead, and as high as it has to be.",
           {{"x", kNumber, false, "where its toes land, metres"},
            {"y", kNumber, false, "where its toes land, metres"},
            {"height", kNumber, false, "how far its centre of mass rises, metres"},
            kDrag},
           AddJump}};
}

}  // namespace hazumi::edit
