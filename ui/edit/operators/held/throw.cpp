// A held object is thrown onto a spot: the dynamics region that moves the arm while it lets go
// starts as fast as it has to.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analysis/object_landing.h"
#include "engine/project/compile.h"
#include "ui/edit/operators/held/held_objects.h"
#include "ui/edit/operators/held/holders.h"
#include "ui/edit/operators/held/throws.h"
#include "ui/edit/operators/keys/start_rate.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

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

// All but its hinges.
Result<ThrowCase> CaseOf(int object, Session* session) {
  const Animation* animation = session->animation();
  if (!animation) return session->WholeMotion().error();
  const Project& project = session->project();
  const Result<HolderSpan> release =
      ReleaseOf(project.held_objects[object], project.frames, session->frame());
  if (!release.ok()) return release.error();
  ThrowCase of;
  of.object = object;
  of.holder = release.value().number;
  of.release = release.value().last;
  const auto holder = animation->figure->FindGroup(release.value().joint);
  size_t most = 0;
  for (size_t i = 0; holder && i < animation->regions.size(); ++i) {
    const DynamicsRegion& region = animation->regions[i];
    if (of.release <= region.first_frame || of.release > region.last_frame) continue;
    const size_t count = FreeHinges(region, *holder, *animation).size();
    if (count <= most) continue;
    most = count;
    of.region = static_cast<int>(i);
  }
  if (most > 0) return of;
  return Refusal("object", "no dynamics region moves " + release.value().joint + " in frame " +
                               std::to_string(of.release) +
                               ", in which it lets go: mark one that begins before that");
}

// Keys that it has from this frame on, until the next one has it.
void ClearFlight(int release, const ThrowCase& of, Project* project) {
  ProjectHeldObject& object = project->held_objects[of.object];
  double until = std::numeric_limits<double>::infinity();
  for (const ProjectHolder& holder : object.holders) {
    if (holder.first_frame > of.release) until = std::min<double>(until, holder.first_frame);
  }
  for (ProjectCurve& curve : object.position.curves) {
    std::erase_if(curve.keys,
                  [&](const ProjectKey& key) { return key.frame >= release && key.frame < until; });
  }
}

// Where it lay before the thrower took it, it lies until then: it does not begin to go to where it
// is thrown.
void LieUntilTaken(const ThrowCase& of, Project* project) {
  ProjectHeldObject& object = project->held_objects[of.object];
  if (of.holder < 0) return;
  const int taken = object.holders[of.holder].first_frame;
  for (ProjectCurve& curve : object.position.curves) {
    ProjectKey* last = nullptr;
    for (ProjectKey& key : curve.keys) {
      if (key.frame <= taken) last = &key;
    }
    if (last) last->interpolation = Interpolation::kHold;
  }
}

// Limits of work (Work): a few seconds of computing.
constexpr double kMostWork = 2.4e7, kMostForAdvice = 1.2e7;

// What would help where a throw misses: a region that takes no speed away, if that does.
Error WithAdvice(Error error, const Vec3& spot, const std::optional<double>& height,
                 const ThrowCase& of, Animation animation) {
  if (error.code != ErrorCode::kSemantics) return error;
  std::vector<double>& friction = animation.regions[of.region].friction;
  if (std::all_of(friction.begin(), friction.end(), [](double f) { return f == 1.0; })) {
    return error;
  }
  std::fill(friction.begin(), friction.end(), 1.0);
  if (ThrowAim(animation, of, kMostForAdvice).At(spot, height).ok()) {
    error.message += "; it gets there if \"" + animation.regions[of.region].name +
                     "\" takes no speed away (friction 1)";
  }
  return error;
}

}  // namespace

bool HasThrow(int object, Session* session) {
  const Project& project = session->project();
  const std::vector<HolderSpan> spans = HoldersOf(project.held_objects[object], project.frames);
  const HolderSpan* holder = HolderAt(static_cast<int>(session->frame()), spans);
  const bool keeps_it = holder && !holder->is_let_go;
  return !keeps_it && CaseOf(object, session).ok();
}

std::vector<ParameterInfo> ThrowParameters() {
  return {{"object", kText, true, "the held object's name", Thing::kHeldObject},
          {"x", kNumber, true, "the spot, metres"},
          {"y", kNumber, true, "the spot, metres"},
          {"z", kNumber, false, "the spot, metres; not given: 0"},
          {"height", kNumber, false, "how far it rises above the hand, metres"},
          kDrag};
}

ThrowTarget TargetOf(const Parameters& p) {
  ThrowTarget target = {Vec3(p.number("x"), p.number("y"), p.number("z")), std::nullopt};
  if (p.has("height")) target.height = p.number("height");
  return target;
}

Result<Done> PutThrown(Session* session, const char* label, Project project, const Parameters& p) {
  return session->Edit(
      label,
      [&](Project* changed) -> Result<Done> {
        *changed = std::move(project);
        return Done();
      },
      p.text("drag"));
}

Result<Done> ThrowTo(const ThrowTarget& target, ThrowCase of, std::shared_ptr<const Figure> figure,
                     Project* project) {
  constexpr double kSeenLying = 0.6;  // [s]
  const Result<Compiled> compiled = CompileAnimation(*project, nullptr, std::move(figure));
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  if (!(animation.gravity > 0.0)) return Refusal("object", "without gravity nothing comes down");
  const ProjectHeldObject& object = project->held_objects[of.object];
  const std::string& joint = of.holder < 0 ? object.joint : object.holders[of.holder].joint;
  of.hinges =
      FreeHinges(animation.regions[of.region], *animation.figure->FindGroup(joint), animation);
  const double radius = InnerRadius(animation.held_objects[of.object]);
  const Vec3 spot = target.ground + radius * Vec3::UnitZ();
  ThrowAim aim(animation, of, kMostWork);
  const Result<AimedThrow> aimed = aim.At(spot, target.height);
  if (!aimed.ok()) return WithAdvice(aimed.error(), spot, target.height, of, animation);
  ClearFlight(std::min(of.release, aimed.value().release), of, project);
  PutThrow(of, aimed.value(), aim.start(), animation, project);
  const double flown = animation.rate.FrameAt(aimed.value().path.seconds);
  const int down = aimed.value().release + std::max(1, static_cast<int>(std::ceil(flown)));
  LieUntilTaken(of, project);
  PutPosition(spot, down, &project->held_objects[of.object]);
  const int seen = down + static_cast<int>(std::lround(animation.rate.FrameAt(kSeenLying)));
  project->frames.last = std::max(project->frames.last, seen);
  return Done();
}

namespace {

Result<Done> ThrowOnto(Session* session, const Parameters& p) {
  Project project = session->project();
  const Result<ProjectHeldObject*> object =
      EntryNamed(p.text("object"), "object", &project.held_objects);
  if (!object.ok()) return object.error();
  const int index = static_cast<int>(object.value() - project.held_objects.data());
  Result<ThrowCase> of = CaseOf(index, session);
  if (!of.ok()) return of.error();
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  const ThrowTarget target = TargetOf(p);
  const Animation& animation = *session->animation();
  SwingAnew(target, animation, *motion.value(), &of.value(), &project);
  Result<Done> thrown = ThrowTo(target, of.value(), animation.figure, &project);
  if (!thrown.ok()) return thrown;
  return PutThrown(session, "Throw onto", std::move(project), p);
}

}  // namespace

std::vector<Operator> ThrowOperators() {
  return {{"held.throw_onto", "Throw onto",
           "Aims a throw: the dynamics region that moves the arm as it lets go starts as fast as "
           "it has to for the object to come down on a spot, where it lies then. Not given how "
           "high: as slowly as it gets there past what stands in between.",
           ThrowParameters(), ThrowOnto}};
}

}  // namespace hazumi::edit
