// A flight that keys have is given to gravity.

#include <cmath>
#include <memory>

#include "engine/bake/incremental_bake.h"
#include "ui/edit/edits.h"
#include "ui/edit/root_curves.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

struct FlightSpan {
  int first, last;  // frames: in the air on both, and between
};

// Where the keys have the CoM, and the root's origin beside the flight [m].
struct KeyedFlight {
  Vec3 com_first, com_last;
  Vec3 root_before, root_first, root_after;  // on the frame before, the first, that after the last
  Vec3 rate_before, rate_after;              // [m/s]
};

// The nearest that there is.
const MotionFrame& FrameOf(const Motion& motion, int frame) {
  const int i = std::clamp(frame - motion.frames.front().frame, 0,
                           static_cast<int>(motion.frames.size()) - 1);
  return motion.frames[i];
}

Result<KeyedFlight> AsKeyed(const FlightSpan& span, Session* session) {
  const ProjectFrames& all = session->project().frames;
  if (span.first < all.first || span.last > all.last || span.first > span.last - 2) {
    return Refusal("last", "a flight has three frames at least, from " + std::to_string(all.first) +
                               " to " + std::to_string(all.last));
  }
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  for (const PlacementSpan& other : session->animation()->placements) {
    if (other.kind == PlacementKind::kKeyed) continue;
    if (other.last_frame <= span.first || other.first_frame >= span.last) continue;
    return Refusal("first", std::string("frames ") + std::to_string(other.first_frame) + " to " +
                                std::to_string(other.last_frame) +
                                " are placed by a pin or by gravity already");
  }
  const auto at = [&](int frame) -> const MotionFrame& { return FrameOf(*motion.value(), frame); };
  return KeyedFlight{at(span.first).com,
                     at(span.last).com,
                     at(span.first - 1).X_WR.p,
                     at(span.first).X_WR.p,
                     at(span.last + 1).X_WR.p,
                     at(span.first - 1).before.root_v,
                     at(span.last + 1).after.root_v};
}

// Where there is no key: one that leaves the curve as it is, of the kind of the one before it. A
// quadratic one goes on as fast as the curve arrives, so that it has to say how fast that was.
void KeepShape(double frame, double value, double rate, ProjectCurve* curve) {
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

// The span, and the root's rate where it takes off [m/s]. Keys beside it keep the motion there as
// it was.
Result<Done> GiveToGravity(const FlightSpan& span, const KeyedFlight& keyed, const Vec3& rate,
                           Project* project) {
  for (int i = 0; i < 3; ++i) {
    ProjectCurve& curve = project->root.curves[kRootX + i];
    if (span.first > project->frames.first) {
      KeepShape(span.first - 1, keyed.root_before[i], keyed.rate_before[i], &curve);
    }
    if (span.last < project->frames.last)
      KeepShape(span.last + 1, keyed.root_after[i], keyed.rate_after[i], &curve);
    const ProjectKey* old = KeyOn(span.first, curve);
    ProjectKey key = old ? *old : ProjectKey();
    key.frame = span.first;
    key.value = old ? old->value : keyed.root_first[i];
    key.rate = WithoutRoundOff(rate[i]);
    key.interpolation = Interpolation::kCubic;
    PutKey(key, &curve);
  }
  ProjectPlacement placement;
  placement.kind = PlacementKind::kGravity;
  placement.first_frame = span.first;
  placement.last_frame = span.last;
  return PutPlacement(std::move(placement), true, &project->placements);
}

// The flight with one rate or another. What lies before it is baked once.
class Tries {
 public:
  Tries(const FlightSpan& span, const KeyedFlight& keyed, const Project& project)
      : span_(span), keyed_(keyed), project_(project) {}

  // Up to a frame.
  Result<const Motion*> Fly(const Vec3& rate, int to) {
    Project project = project_;
    const Result<Done> given = GiveToGravity(span_, keyed_, rate, &project);
    if (!given.ok()) return given.error();
    const Result<Compiled> compiled = CompileAnimation(project);
    if (!compiled.ok()) return compiled.error();
    if (bake_) bake_->Update(compiled.value().animation);
    if (!bake_) bake_ = std::make_unique<IncrementalBake>(compiled.value().animation);
    if (const auto error = bake_->BakeTo(to)) return *error;
    return &bake_->motion();
  }

 private:
  const FlightSpan& span_;
  const KeyedFlight& keyed_;
  const Project& project_;
  std::unique_ptr<IncrementalBake> bake_;
};

bool Lands(const Motion& motion, const FlightSpan& span) {
  return std::any_of(motion.events.begin(), motion.events.end(), [&](const MotionEvent& event) {
    return event.kind == EventKind::kLanding && event.frame > span.first && event.frame < span.last;
  });
}

// The root's rate with which the CoM flies from where the keys have it on the first frame to where
// they have it on the last one. What the limbs add to the CoM's velocity is seen in a first try,
// what a coarse step adds in further ones; a flight that lands early is left with the first.
Result<Vec3> RateOfRoot(const FlightSpan& span, const KeyedFlight& keyed, Session* session) {
  const Animation& animation = *session->animation();
  const double step = animation.rate.SecondsAt(1.0), duration = step * (span.last - span.first);
  const Vec3 gravity(0.0, 0.0, -animation.gravity);
  const Vec3 wanted = (keyed.com_last - keyed.com_first) / duration - 0.5 * duration * gravity;
  Tries tries(span, keyed, session->project());
  const Result<const Motion*> begun = tries.Fly(wanted, span.first + 1);
  if (!begun.ok()) return begun.error();
  const Vec3 moved = FrameOf(*begun.value(), span.first + 1).com - keyed.com_first;
  Vec3 rate = wanted + wanted - (moved / step - 0.5 * step * gravity);
  for (int i = 0; i < 3; ++i) {
    constexpr double kThere = 1e-7;  // [m]
    const Result<const Motion*> flown = tries.Fly(rate, span.last);
    if (!flown.ok()) return flown.error();
    if (Lands(*flown.value(), span)) break;
    const Vec3 off = keyed.com_last - FrameOf(*flown.value(), span.last).com;
    if (off.norm() < kThere) break;
    rate += off / duration;
  }
  return rate;
}

Result<Done> Fly(Session* session, const Parameters& p) {
  const FlightSpan span = {p.integer("first"), p.integer("last")};
  const Result<KeyedFlight> keyed = AsKeyed(span, session);
  if (!keyed.ok()) return keyed.error();
  const Result<Vec3> rate = RateOfRoot(span, keyed.value(), session);
  if (!rate.ok()) return rate.error();
  return session->Edit("Place flight by gravity", [&](Project* project) -> Result<Done> {
    return GiveToGravity(span, keyed.value(), rate.value(), project);
  });
}

}  // namespace

std::vector<Operator> FlightOperators() {
  return {{"placement.flight",
           "Place flight by gravity",
           "Gives a flight that keys have to gravity: it takes off so fast that it lands where the "
           "keys have it.",
           {{"first", kInteger, true, "first frame in the air"},
            {"last", kInteger, true, "last frame in the air"}},
           Fly}};
}

}  // namespace hazumi::edit
