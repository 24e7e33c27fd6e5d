// A flight that keys have is given to gravity.

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/makers/flights/flight_arc.h"
#include "engine/makers/flights/flights.h"
#include "engine/makers/trial_bakes.h"
#include "engine/placement/contact.h"
#include "engine/project/checks/checks.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"

namespace hazumi::makers {

namespace {

constexpr double kMostMiss = 0.02;  // so far from its key it may land [m]

// Keys of a flight.
struct FlightKeys {
  FlightSpan span;
  int by_gravity = 0;              // first frame that gravity places
  bool lands = false;              // on the last frame
  std::vector<Vec3> roots, rates;  // of the root, from span.first to by_gravity [m, m/s]
  Vec3 root_before, root_after;    // on the frame before the first, that after the last
  Vec3 rate_before, rate_after;    // [m/s]
  bool stands() const { return by_gravity > span.first; }  // on the first frame
};

std::string Frame(int frame) { return "F" + std::to_string(frame); }
std::string Centimetres(double metres) { return FormatShort(100.0 * metres) + " cm"; }
std::string Inside(const FlightArc::Nearness& nearness, int frame) {
  return Quoted(nearness.link) + " is " + Centimetres(-nearness.clearance) + " inside " +
         Quoted(nearness.object) + " at " + Frame(frame);
}

std::optional<Error> CheckFree(const FlightSpan& span, const Animation& animation) {
  for (const PlacementSpan& other : animation.placements) {
    if (other.kind == PlacementKind::kKeyed) continue;
    if (other.last_frame <= span.first || other.first_frame >= span.last) continue;
    return Refusal("first", std::string("frames ") + std::to_string(other.first_frame) + " to " +
                                std::to_string(other.last_frame) +
                                " are placed by a pin or by gravity already");
  }
  return std::nullopt;
}

// Whether a pin places the figure up to a frame: gravity would take over with the pin's speed.
bool IsPinnedUntil(int frame, const Animation& animation) {
  return std::any_of(animation.placements.begin(), animation.placements.end(),
                     [&](const PlacementSpan& span) {
                       return span.kind == PlacementKind::kPinned && span.last_frame == frame;
                     });
}

// Gravity would hold a figure that touches something. One that stands on the first frame, or is
// pinned, is keyed on its way until it is off the ground.
Result<int> FirstByGravity(const FlightArc& arc, const FlightSpan& span,
                           const Animation& animation) {
  constexpr int kMostFrames = 3;
  const int last = std::min(span.first + kMostFrames, span.last - 2);
  const int first = std::min(span.first + (IsPinnedUntil(span.first, animation) ? 1 : 0), last);
  for (int frame = first; frame <= last; ++frame) {
    const auto nearness = arc.NearnessAt(frame);
    if (!nearness || nearness->clearance > 2.0 * kTouching) return frame;
  }
  const auto nearness = arc.NearnessAt(last);
  return Refusal("first", "on the way to where the keys have it at " + Frame(span.last) + " " +
                              Inside(*nearness, last) + ", " + std::to_string(last - span.first) +
                              " frames after it took off: it does not get off the ground");
}

// It flies to a hair inside the ground, so that it lands, and not before.
void EndOnTheGround(double clearance, int last, FlightArc* arc) {
  constexpr double kHair = 1e-6;  // [m]
  arc->EndAt(arc->ComAt(last) - (clearance + kHair) * Vec3::UnitZ());
}

Result<FlightKeys> KeysOf(const FlightSpan& span, const Animation& animation, const Motion& motion,
                          FlightArc* planned) {
  constexpr double kLands = 1e-4;  // [m]
  FlightArc& arc = *planned;
  const auto landing = arc.NearnessAt(span.last);
  if (landing && landing->clearance < -kMostMiss) {
    return Refusal("last", Inside(*landing, span.last) +
                               ": key the root so much higher there, or let it land before");
  }
  // The keys have the figure on the ground, or not much inside.
  const bool lands = landing && landing->clearance < kLands;
  if (lands) EndOnTheGround(landing->clearance, span.last, &arc);
  const Result<int> by_gravity = FirstByGravity(arc, span, animation);
  if (!by_gravity.ok()) return by_gravity.error();
  const MotionFrame& before = FrameOf(motion, span.first - 1);
  const MotionFrame& after = FrameOf(motion, span.last + 1);
  FlightKeys keys{span,
                  by_gravity.value(),
                  lands,
                  {},
                  {},
                  before.X_WR.p,
                  after.X_WR.p,
                  before.before.root_v,
                  after.after.root_v};
  for (int frame = span.first; frame <= keys.by_gravity; ++frame) {
    keys.roots.push_back(arc.RootAt(frame));
    keys.rates.push_back(arc.RootVelocityAt(frame));
  }
  return keys;
}

// Adds a key that leaves the curve as it is, of the kind of the key before it, unless there is one.
// A quadratic one goes on as fast as the curve arrives, so that it has to say how fast that was.
void KeepShape(double frame, double value, double rate, const ProjectRate& fps,
               ProjectCurve* curve) {
  ToCubicsAround(frame, fps, curve);
  if (ProjectKey* old = KeyOn(frame, curve)) {
    if (old->interpolation == Interpolation::kQuadratic && !old->rate) old->rate = rate;
    return;
  }
  ProjectKey key;
  for (const ProjectKey& earlier : curve->keys) {
    if (earlier.frame < frame) key.interpolation = earlier.interpolation;
  }
  key.frame = frame;
  key.value = value;
  const bool has_tangent =
      key.interpolation == Interpolation::kCubic || key.interpolation == Interpolation::kQuadratic;
  if (has_tangent) key.rate = rate;
  PutKey(key, curve);
}

// Keeps the curve before take-off from swinging out for its speed.
void ArriveAsSlow(double frame, double rate, ProjectCurve* curve) {
  ProjectKey* key = KeyOn(frame, curve);
  if (key->interpolation != Interpolation::kCubic) return;
  key->interpolation = Interpolation::kQuadratic;
  if (!key->rate) key->rate = rate;
}

// The way from the ground, up to the first frame that gravity places.
void KeyWay(const FlightKeys& keys, int axis, ProjectCurve* curve) {
  std::erase_if(curve->keys, [&](const ProjectKey& key) {
    return key.frame > keys.span.first && key.frame < keys.by_gravity;
  });
  for (int frame = keys.span.first; frame <= keys.by_gravity; ++frame) {
    const int k = frame - keys.span.first;
    const ProjectKey* old = KeyOn(frame, *curve);
    ProjectKey key = old ? *old : ProjectKey();
    key.frame = frame;
    if (!old || k > 0) key.value = WithoutRoundOff(keys.roots[k][axis]);
    key.rate = WithoutRoundOff(keys.rates[k][axis]);
    key.interpolation = Interpolation::kCubic;
    key.length_out.reset();
    if (k > 0) {
      key.rate_in.reset();
      key.length_in.reset();
    }
    PutKey(key, curve);
  }
}

// Keys beside the span keep the motion there as it was.
Result<Done> GiveToGravity(const FlightKeys& keys, Project* project) {
  const FlightSpan& span = keys.span;
  for (int i = 0; i < 3; ++i) {
    ProjectCurve& curve = project->root.curves[kRootX + i];
    if (span.first > project->frames.first) {
      KeepShape(span.first - 1, keys.root_before[i], keys.rate_before[i], project->fps, &curve);
      if (keys.stands()) ArriveAsSlow(span.first - 1, keys.rate_before[i], &curve);
    }
    if (span.last < project->frames.last)
      KeepShape(span.last + 1, keys.root_after[i], keys.rate_after[i], project->fps, &curve);
    KeyWay(keys, i, &curve);
  }
  ProjectPlacement placement;
  placement.kind = PlacementKind::kGravity;
  placement.first_frame = keys.by_gravity;
  placement.last_frame = span.last;
  return PutPlacement(std::move(placement), true, &project->placements);
}

// Bakes the flight with the rates that it has now.
Result<const Motion*> Fly(const FlightKeys& keys, Project project, TrialBakes* trials) {
  const Result<Done> given = GiveToGravity(keys, &project);
  if (!given.ok()) return given.error();
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) return compiled.error();
  return trials->BakeTo(keys.span.last, compiled.value().animation);
}

// On the way, not as it ends.
const MotionEvent* LandingIn(const Motion& motion, const FlightKeys& keys) {
  constexpr double kAsItEnds = 1e-3;  // [s]
  const double end = motion.rate.SecondsAt(keys.span.last) - kAsItEnds;
  const auto landing =
      std::find_if(motion.events.begin(), motion.events.end(), [&](const MotionEvent& event) {
        return event.kind == EventKind::kLanding && event.frame > keys.by_gravity &&
               event.time < end;
      });
  return landing == motion.events.end() ? nullptr : &*landing;
}

// A flight that ends elsewhere than its keys: what was in the way.
std::optional<Error> CheckFlown(const FlightArc& arc, const FlightKeys& keys,
                                const Motion& motion) {
  const int last = keys.span.last;
  const double off = (FrameOf(motion, last).com - arc.ComAt(last)).norm();
  if (off <= kMostMiss) return std::nullopt;
  const std::string far = Centimetres(off) + " from where the keys have it at " + Frame(last);
  const MotionEvent* landing = LandingIn(motion, keys);
  if (!landing) return Refusal("last", "gravity leaves the figure " + far);
  const auto met = arc.NearnessIn(FrameOf(motion, landing->frame));
  return Refusal("last", Quoted(met->link) + " meets " + Quoted(met->object) + " at " +
                             Frame(landing->frame) + " on the way, which leaves the figure " + far);
}

// The arc ends where the figure is on the ground as it was flown there: a region that moves joints
// in the flight has them elsewhere than the keys. Whether that is another place.
bool EndAsFlown(MotionFrame flown, const FlightKeys& keys, FlightArc* arc) {
  constexpr double kElsewhere = 2e-6;  // [m]
  const int last = keys.span.last;
  flown.X_WR.p += arc->ComAt(last) - flown.com;
  const auto nearness = arc->NearnessIn(flown);
  if (!keys.lands || !nearness || std::abs(nearness->clearance) < kElsewhere) return false;
  EndOnTheGround(nearness->clearance, last, arc);
  return true;
}

// The last frame on which a trial flies as it is aimed: before it lands early, or the last of all.
int LastOfFlight(const Motion& motion, const FlightKeys& keys) {
  const MotionEvent* landing = LandingIn(motion, keys);
  return landing ? landing->frame - 1 : keys.span.last;
}

// Sets the rate with which gravity takes over so that the CoM is at the arc's end on the last
// frame. What a coarse step adds is seen in the trials. One that lands early is brought onto the
// arc up to there, and left as it is if it lands early on the arc, too.
Result<FlightReport> Aim(const Project& project, double step, FlightKeys* keys, FlightArc* arc) {
  constexpr double kThere = 2e-6, kOnTheWay = 1e-3;  // [m]
  constexpr int kTrials = 12;
  TrialBakes trials;
  FlightReport report;
  while (true) {
    const Result<const Motion*> flown = Fly(*keys, project, &trials);
    if (!flown.ok()) return flown.error();
    ++report.trials;
    const MotionFrame& end = FrameOf(*flown.value(), keys->span.last);
    const int last = LastOfFlight(*flown.value(), *keys), frames = last - keys->by_gravity;
    const bool is_early = last < keys->span.last;
    const bool ends_elsewhere = EndAsFlown(end, *keys, arc);
    const Vec3 off = arc->ComAt(last) - FrameOf(*flown.value(), last).com;
    const bool is_there = !ends_elsewhere && off.norm() < (is_early ? kOnTheWay : kThere);
    if (is_there || frames < 1 || report.trials == kTrials) {
      if (const auto error = CheckFlown(*arc, *keys, *flown.value())) return *error;
      break;
    }
    keys->rates.back() += off / (step * frames);
  }
  report.by_gravity = keys->by_gravity;
  report.root_velocity = keys->rates.back();
  report.work = trials.work();
  return report;
}

std::optional<Error> CheckSpan(const FlightSpan& span, const Animation& animation) {
  const bool is_within = span.first >= animation.first_frame && span.last <= animation.last_frame;
  if (is_within && span.first <= span.last - 2) return {};
  return Refusal("last", "a flight has three frames at least, from " +
                             std::to_string(animation.first_frame) + " to " +
                             std::to_string(animation.last_frame));
}

}  // namespace

Result<MadeFlight> MakeFlight(const FlightSpan& span, const Project& project,
                              const Animation& animation, const Motion& motion) {
  if (const auto error = CheckSpan(span, animation)) return *error;
  if (const auto error = CheckFree(span, animation)) return *error;
  FlightArc arc(animation, motion, span);
  Result<FlightKeys> keys = KeysOf(span, animation, motion, &arc);
  if (!keys.ok()) return keys.error();
  const Result<FlightReport> aimed =
      Aim(project, animation.rate.SecondsAt(1.0), &keys.value(), &arc);
  if (!aimed.ok()) return aimed.error();
  MadeFlight made = {project, aimed.value()};
  const Result<Done> given = GiveToGravity(keys.value(), &made.project);
  if (!given.ok()) return given.error();
  return made;
}

Result<MadeFlight> MakeFlight(const FlightSpan& span, const Project& project) {
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  if (const auto error = CheckSpan(span, animation)) return *error;
  TrialBakes keyed;
  const Result<const Motion*> motion =
      keyed.BakeTo(std::min(span.last + 1, animation.last_frame), animation);
  if (!motion.ok()) return motion.error();
  return MakeFlight(span, project, animation, *motion.value());
}

}  // namespace hazumi::makers
