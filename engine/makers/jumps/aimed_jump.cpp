// A jump is aimed at another spot. Its poses are those of the motion there is on the frames of its
// phases f_i; a jump onto the new spot has its phases on frames g_i (jump_plan.cpp), and what is
// keyed in between goes along: a key on frame t with f_i <= t <= f_i+1 to
//   g_i + (t - f_i) (g_i+1 - g_i) / (f_i+1 - f_i),
// and its rates so much faster as its stretch of the jump is shorter. Where its keys say how fast
// it takes off and lands, as those of a jump that was made do, that and its lean there are found
// anew (jump_contacts.cpp).

#include <algorithm>
#include <cmath>

#include "engine/makers/flights/flight_arc.h"
#include "engine/makers/jumps/jump_plan.h"
#include "engine/makers/keyed_moves.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/key_selection.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"

namespace hazumi::makers {

namespace {

// First frame, phases, last frame.
std::vector<int> AllFrames(int start, const JumpFrames& phases, int end) {
  std::vector<int> all = {start};
  all.insert(all.end(), phases.begin(), phases.end());
  all.push_back(end);
  return all;
}

// Map from old frames to new ones; both have one for each phase.
struct Retiming {
  std::vector<int> from, to;

  // The stretch in which a frame is, or which ends on it.
  size_t StretchOf(double frame) const {
    size_t i = 0;
    while (i + 2 < from.size() && frame > from[i + 1]) ++i;
    return i;
  }
  double SpeedIn(size_t stretch) const {
    return static_cast<double>(from[stretch + 1] - from[stretch]) / (to[stretch + 1] - to[stretch]);
  }
  double operator()(double frame) const {
    if (frame < from.front() || frame > from.back()) return frame;
    const size_t i = StretchOf(frame);
    return std::round(to[i] + (frame - from[i]) / SpeedIn(i));
  }
};

void RetimeCurve(const Retiming& retiming, ProjectCurve* curve) {
  std::vector<ProjectKey> moved;
  for (const ProjectKey& key : curve->keys) {
    if (key.frame >= retiming.from.front() && key.frame <= retiming.from.back()) {
      moved.push_back(key);
    }
  }
  RemoveKeysIn(retiming.from.front(), std::max(retiming.from.back(), retiming.to.back()), curve);
  for (ProjectKey& key : moved) {
    const double speed = retiming.SpeedIn(retiming.StretchOf(key.frame));
    if (key.rate) *key.rate = WithoutRoundOff(*key.rate * speed);
    if (key.rate_in) *key.rate_in = WithoutRoundOff(*key.rate_in * speed);
    key.frame = retiming(key.frame);
    PutKey(key, curve);
  }
}

// All joints and the root's angles, and what else has frames there.
Result<Done> Retime(const Retiming& retiming, const Figure& figure, Project* project) {
  KeySelection all;
  for (const std::string& name : CurveNames(*project)) {
    for (const ProjectKey& key : FindCurve(name, *project)->keys) {
      const bool is_in = key.frame >= retiming.from.front() && key.frame <= retiming.from.back();
      if (is_in) all[name].insert(key.frame);
    }
  }
  CarryAlong(all, figure, retiming, project);
  for (const std::string& name : CurveNames(*project)) {
    const Result<ProjectCurve*> curve = CurveNamed(name, figure, project);
    if (!curve.ok()) return curve.error();
    RetimeCurve(retiming, curve.value());
  }
  return Done();
}

// The last frame on which a jump may end that ended on `frame`, for what comes after it; none if
// nothing does.
std::optional<int> LatestEnd(int frame, const Project& project) {
  std::optional<int> latest;
  const auto take = [&](int other) { latest = latest ? std::min(*latest, other) : other; };
  for (const std::string& name : CurveNames(project)) {
    for (const ProjectKey& key : FindCurve(name, project)->keys) {
      if (key.frame > frame) take(static_cast<int>(std::ceil(key.frame)) - 1);
    }
  }
  const auto take_spans = [&](const auto& spans) {
    for (const auto& span : spans) {
      if (span.first_frame >= frame) take(span.first_frame);
    }
  };
  take_spans(project.placements);
  take_spans(project.regions);
  take_spans(project.holds);
  return latest;
}

// A jump there is, in its motion.
class KnownJump {
 public:
  KnownJump(const JumpSpans& spans, const Project& project, const Animation& animation,
            const Motion& motion, const JumpBody& body)
      : project_(project), motion_(motion), body_(body) {
    pins_ = {project.placements[spans.before], project.placements[spans.after]};
    const int take_off = pins_.before.last_frame;
    frames_[kTakeOff] = take_off;
    frames_[kLanding] = project.placements[spans.flight].last_frame;
    frames_[kCrouch] = LowestBetween(start(), take_off);
    frames_[kAbsorbed] = LowestBetween(frames_[kLanding], end());
    const int flown = frames_[kLanding] - take_off;
    frames_[kStretched] =
        PosedNear(take_off + std::min(FramesOf(kStretchSeconds, 1, animation), flown / 3));
    frames_[kApex] = std::clamp(PosedNear(take_off + FramesOf(SecondsUp(animation), 1, animation)),
                                frames_[kStretched] + 1, frames_[kLanding] - 1);
  }

  int start() const { return pins_.before.first_frame; }
  int end() const { return pins_.after.last_frame; }
  const JumpFrames& frames() const { return frames_; }
  const JumpBody& body() const { return body_; }
  const JumpPins& pins() const { return pins_; }
  JumpLengths lengths() const { return {frames_[kCrouch] - start(), end() - frames_[kAbsorbed]}; }
  Stance StanceOn(int frame) const {
    const MotionFrame& there = FrameOf(motion_, frame);
    const auto values = RootValues(there.X_WR, project_.root, frame);
    return {there.q, Vec3(values[kRootAngleZ], values[kRootAngleY], values[kRootAngleX])};
  }
  Vec3 RootOn(int frame) const { return FrameOf(motion_, frame).X_WR.p; }
  // Returns where its keys have it land; its motion may land elsewhere.
  Vec3 KeyedLanding(Stage* stage) const {
    return stage->ToesOf(StanceOn(frames_[kLanding]), KeyedRoot());
  }

 private:
  Vec3 KeyedRoot() const {
    Vec3 root = RootOn(frames_[kLanding]);
    for (int i = 0; i < 3; ++i) {
      const ProjectKey* key = KeyOn(frames_[kLanding], project_.root.curves[kRootX + i]);
      if (key) root[i] = key->value;
    }
    return root;
  }
  // Returns the time from take-off to apex of the flight that its keys have, which takes T:
  // c1 = c0 + v T - g T^2 / 2, up for v / g.
  double SecondsUp(const Animation& animation) const {
    const double T = animation.rate.SecondsAt(frames_[kLanding] - frames_[kTakeOff]);
    const double c0 = FrameOf(motion_, frames_[kTakeOff]).com.z();
    const double c1 = Stage(animation, body_).ComOf(StanceOn(frames_[kLanding]), KeyedRoot()).z();
    return animation.gravity > 0.0 ? ((c1 - c0) / T) / animation.gravity + 0.5 * T : 0.5 * T;
  }
  // Returns the nearest frame in the air on which a made jump has a pose, or `frame`.
  int PosedNear(int frame) const {
    constexpr int kFar = 3;
    for (int i = 0; i <= 2 * kFar; ++i) {
      const int other = frame + (i % 2 ? -(i + 1) / 2 : i / 2);
      const bool flies = other > frames_[kTakeOff] && other < frames_[kLanding];
      if (flies && HasPose(other, body_, project_)) return other;
    }
    return frame;
  }
  // The frame between two others on which the CoM is lowest, of those with a pose if there are any:
  // keys of a jump that was made may have it lowest beside its pose.
  int LowestBetween(int first, int last) const {
    std::optional<int> lowest, posed;
    const auto take = [&](int frame, std::optional<int>* best) {
      const double z = FrameOf(motion_, frame).com.z();
      if (!*best || z < FrameOf(motion_, **best).com.z()) *best = frame;
    };
    for (int frame = first + 1; frame < last; ++frame) {
      take(frame, &lowest);
      if (HasPose(frame, body_, project_)) take(frame, &posed);
    }
    return posed ? *posed : *lowest;
  }

  const Project& project_;
  const Motion& motion_;
  const JumpBody& body_;
  JumpPins pins_;
  JumpFrames frames_{};
};

// Ends the jump before the next thing begins: the figure stands up faster, if it must.
Result<Done> EndBy(std::optional<int> latest, JumpPlan* plan) {
  constexpr int kLeastRise = 3;
  if (!latest || plan->end <= *latest) return Done();
  plan->end = *latest;
  if (plan->end >= plan->frames[kAbsorbed] + kLeastRise) return Done();
  return Refusal("height", "it lands in frame " + std::to_string(plan->frames[kLanding]) +
                               ", and after frame " + std::to_string(*latest) +
                               " something else begins: move that later, or jump lower");
}

Result<JumpReport> Jump(const KnownJump& known, const JumpSpans& spans, const Animation& animation,
                        const Vec3& target, const JumpTry& how, Project* project) {
  Stage stage(animation, known.body());
  JumpPlan plan;
  plan.start = known.start();
  plan.before = known.StanceOn(known.start());
  plan.after = known.StanceOn(known.end());
  plan.root_before = known.RootOn(known.start());
  for (int i = 0; i < kNumJumpPhases; ++i) plan.stances[i] = known.StanceOn(known.frames()[i]);
  // From where it stands in the crouch: until then it may bring its feet together.
  const bool stands = StandsOnBothFeet(plan.before, &stage);
  const int standing = stands ? known.start() : known.frames()[kCrouch];
  const JumpSpots spots = {stage.ToesOf(known.StanceOn(standing), known.RootOn(standing)), target};
  const bool is_made = HasContacts(known.frames(), known.body(), *project);
  Result<Done> done = SetRoots(spots, &stage, &plan);
  if (!done.ok()) return done.error();
  done = is_made
             ? PlanContacts(animation, spots, how.height, known.lengths(), how.push, &stage, &plan)
             : SetTimes(animation, how.height, known.lengths(), &stage, &plan);
  if (!done.ok()) return done.error();
  auto& all = project->placements;
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(spans.before),
            all.begin() + static_cast<std::ptrdiff_t>(spans.after) + 1);
  done = EndBy(LatestEnd(known.end(), *project), &plan);
  if (!done.ok()) return done.error();
  done = Retime({AllFrames(known.start(), known.frames(), known.end()),
                 AllFrames(plan.start, plan.frames, plan.end)},
                *animation.figure, project);
  if (!done.ok()) return done.error();
  if (is_made) KeyContacts(plan, known.body(), *animation.figure, project);
  done = PutJump(plan, known.pins(), project);
  if (!done.ok()) return done.error();
  return ReportOf(plan, how.height);
}

}  // namespace

Result<MadeJump> AimJump(const JumpTarget& target, double frame, const Animation& animation,
                         const Motion& motion, const Project& project) {
  const auto spans = JumpAt(frame, project.placements);
  if (!spans) {
    return Refusal("", "there is no jump in this frame: a flight by gravity between two pins");
  }
  const JumpBody body(*animation.figure);
  if (const auto error = body.Check(*animation.figure)) return *error;
  const KnownJump known(*spans, project, animation, motion, body);
  Stage stage(animation, body);
  const Vec3 landing = known.KeyedLanding(&stage);
  const Vec3 spot(target.x.value_or(landing.x()), target.y.value_or(landing.y()), 0.0);
  const auto jump = [&](const JumpTry& how, Project* tried) {
    return Jump(known, *spans, animation, spot, how, tried);
  };
  return JumpAsLow(target.height, {1.0}, jump, project);
}

}  // namespace hazumi::makers
