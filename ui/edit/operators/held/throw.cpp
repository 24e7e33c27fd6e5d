// A held object is thrown onto a spot: the dynamics region that moves the arm while it lets go
// starts as fast as it has to.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "engine/dynamics/kinematics.h"
#include "ui/edit/operators/held/held_objects.h"
#include "ui/edit/operators/held/holders.h"
#include "ui/edit/operators/held/throw_aim.h"
#include "ui/edit/operators/keys/start_rate.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// The next time that it is let go; if there is none the last time.
Result<HolderSpan> ReleaseOf(const ProjectHeldObject& object, const ProjectFrames& frames,
                             double now) {
  std::optional<HolderSpan> found;
  for (const HolderSpan& span : HoldersOf(object, frames)) {
    if (!span.is_let_go) continue;
    found = span;
    if (span.last >= now) break;
  }
  if (found) return *found;
  return Refusal("object", "nobody lets go of \"" + object.name + "\": let go of it first");
}

// Hinges from the holder to the root that the region moves and lets go by itself.
std::vector<JointIndex> FreeHinges(const DynamicsRegion& region, GroupIndex holder,
                                   const Animation& animation) {
  std::vector<JointIndex> hinges;
  const Figure& figure = *animation.figure;
  for (JointIndex j = figure.group(holder).last(); j.is_valid(); j = figure.joint(j).parent) {
    const bool is_in = std::binary_search(region.joints.begin(), region.joints.end(), j);
    if (is_in && !IsTakenOver(region, j, animation)) hinges.push_back(j);
  }
  std::reverse(hinges.begin(), hinges.end());
  return hinges;
}

Result<ThrowCase> CaseOf(int object, Session* session) {
  const Animation* animation = session->animation();
  if (!animation) return session->WholeMotion().error();
  if (!(animation->gravity > 0.0)) return Refusal("object", "without gravity nothing comes down");
  const Project& project = session->project();
  const Result<HolderSpan> release =
      ReleaseOf(project.held_objects[object], project.frames, session->frame());
  if (!release.ok()) return release.error();
  ThrowCase of;
  of.object = object;
  of.holder = release.value().number;
  of.release = release.value().last;
  const auto holder = animation->figure->FindGroup(release.value().joint);
  for (size_t i = 0; holder && i < animation->regions.size(); ++i) {
    const DynamicsRegion& region = animation->regions[i];
    if (of.release <= region.first_frame || of.release > region.last_frame) continue;
    std::vector<JointIndex> hinges = FreeHinges(region, *holder, *animation);
    if (hinges.size() <= of.hinges.size()) continue;
    of.hinges = std::move(hinges);
    of.region = static_cast<int>(i);
  }
  if (!of.hinges.empty()) return of;
  return Refusal("object", "no dynamics region moves " + release.value().joint + " in frame " +
                               std::to_string(of.release) +
                               ", in which it lets go: mark one that begins before that");
}

// What is there before it is aimed.
Result<Done> TakeStart(Session* session, ThrowCase* of) {
  const DynamicsRegion region = session->animation()->regions[of->region];
  const Result<const Motion*> motion = session->MotionTo(region.first_frame);
  if (!motion.ok()) return motion.error();
  const size_t first = static_cast<size_t>(region.first_frame - session->project().frames.first);
  const MotionFrame& start = motion.value()->frames[first];
  const Figure& figure = session->figure();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, start.X_WR, start.q, &ws);
  of->rates.resize(static_cast<int>(of->hinges.size()));
  of->ease.resize(of->rates.size());
  for (size_t i = 0; i < of->hinges.size(); ++i) {
    const JointIndex hinge = of->hinges[i];
    of->rates[static_cast<int>(i)] = start.after.qd[hinge.value()];
    of->ease[static_cast<int>(i)] =
        (ws.body(hinge).p - start.objects[static_cast<size_t>(of->object)].X_WO.p).squaredNorm();
    const std::string& name = figure.joint(hinge).name;
    Result<ProjectKey> key = KeyAtStart(name, region.first_frame, session);
    if (!key.ok()) return key.error();
    of->keys.push_back(std::move(key).value());
  }
  return Done();
}

// It lies on the spot from when it comes down.
void LetItLie(const Vec3& spot, int frame, const ThrowCase& of, Project* project) {
  ProjectHeldObject& object = project->held_objects[of.object];
  for (int axis = 0; axis < 3; ++axis) {
    ProjectKey key;
    key.frame = frame;
    key.value = WithoutRoundOff(spot[axis]);
    PutKey(key, &object.position.curves[axis]);
  }
  project->frames.last = std::max(project->frames.last, frame);
}

// Keys that it had in its flight and after it.
void ClearFlight(const ThrowCase& of, Project* project) {
  ProjectHeldObject& object = project->held_objects[of.object];
  double until = std::numeric_limits<double>::infinity();
  for (const ProjectHolder& holder : object.holders) {
    if (holder.first_frame > of.release) until = std::min<double>(until, holder.first_frame);
  }
  for (ProjectCurve& curve : object.position.curves) {
    std::erase_if(curve.keys, [&](const ProjectKey& key) {
      return key.frame >= of.release && key.frame < until;
    });
  }
}

// Frames in which it could be let go, the one that was given first, then those nearest to it.
std::vector<int> ReleasesOf(const ThrowCase& of, const DynamicsRegion& region) {
  std::vector<int> frames;
  for (int frame = region.first_frame + 1; frame <= region.last_frame; ++frame) {
    frames.push_back(frame);
  }
  std::stable_sort(frames.begin(), frames.end(), [&](int a, int b) {
    return std::abs(a - of.release) < std::abs(b - of.release);
  });
  return frames;
}

// Where the frame in which it lets go will not do, another one of the region is taken; and as
// joints that reach their limits can be in the way, other rates are begun from then. Errors: that
// of the frame that was given.
Result<AimedThrow> Aim(const Project& project, const Animation& animation, const Vec3& spot,
                       std::optional<double> height, ThrowCase* of) {
  constexpr int kStarts = 4;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(12);
  const std::vector<int> releases = ReleasesOf(*of, animation.regions[of->region]);
  std::optional<Error> error;
  for (int start = 0; start < kStarts; ++start) {
    for (const int release : releases) {
      of->release = release;
      Result<AimedThrow> aimed =
          ThrowAim(project, animation.figure, *of, until).At(spot, height, start);
      if (aimed.ok()) return aimed;
      if (aimed.error().code == ErrorCode::kInterrupted) return error.value_or(aimed.error());
      const bool is_near = aimed.error().code == ErrorCode::kSchema;
      if (!error || (is_near && error->code != ErrorCode::kSchema)) error = aimed.error();
    }
  }
  return *error;
}

Result<Done> ThrowOnto(Session* session, const Parameters& p) {
  Project project = session->project();
  const Result<ProjectHeldObject*> object =
      EntryNamed(p.text("object"), "object", &project.held_objects);
  if (!object.ok()) return object.error();
  const int index = static_cast<int>(object.value() - project.held_objects.data());
  Result<ThrowCase> of = CaseOf(index, session);
  if (!of.ok()) return of.error();
  if (Result<Done> start = TakeStart(session, &of.value()); !start.ok()) return start;
  const Animation& animation = *session->animation();
  const double radius = InnerRadius(animation.held_objects[index]);
  const Vec3 spot = Vec3(p.number("x"), p.number("y"), p.number("z") + radius);
  std::optional<double> height;
  if (p.has("height")) height = p.number("height");
  ClearFlight(of.value(), &project);
  const Result<AimedThrow> aimed = Aim(project, animation, spot, height, &of.value());
  if (!aimed.ok()) return aimed.error();
  const double flown = animation.rate.FrameAt(aimed.value().path.seconds);
  const int down = of.value().release + std::max(1, static_cast<int>(std::ceil(flown)));
  return session->Edit(
      "Throw onto",
      [&](Project* changed) -> Result<Done> {
        ClearFlight(of.value(), changed);
        ThrowAim::Apply(of.value(), aimed.value().rates, *animation.figure, changed);
        LetItLie(spot, down, of.value(), changed);
        return Done();
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> ThrowOperators() {
  return {{"held.throw_onto",
           "Throw onto",
           "Aims a throw: the dynamics region that moves the arm as it lets go starts as fast as "
           "it has to for the object to come down on a spot, where it lies then. Not given how "
           "high: as slowly as it gets there past what stands in between.",
           {{"object", kText, true, "the held object's name", Thing::kHeldObject},
            {"x", kNumber, true, "the spot, metres"},
            {"y", kNumber, true, "the spot, metres"},
            {"z", kNumber, false, "the spot, metres; not given: 0"},
            {"height", kNumber, false, "how far it rises above the hand, metres"},
            kDrag},
           ThrowOnto}};
}

}  // namespace hazumi::edit
