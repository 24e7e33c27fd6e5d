// A held object is thrown onto a spot: the dynamics region that moves the arm while it lets go
// starts as fast as it has to.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analysis/object_landing.h"
#include "engine/makers/throws/throw_aim.h"
#include "engine/project/compile.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/holders.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

namespace {

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

// Returns the throw without its hinges.
Result<ThrowCase> CaseOf(int object, double frame, const Animation& animation,
                         const Project& project) {
  const Result<HolderSpan> release = ReleaseOf(project.held_objects[object], project.frames, frame);
  if (!release.ok()) return release.error();
  ThrowCase of;
  of.object = object;
  of.holder = release.value().number;
  of.release = release.value().last;
  const auto holder = animation.figure->FindGroup(release.value().joint);
  size_t most = 0;
  for (size_t i = 0; holder && i < animation.regions.size(); ++i) {
    const DynamicsRegion& region = animation.regions[i];
    if (of.release <= region.first_frame || of.release > region.last_frame) continue;
    const size_t count = FreeHinges(region, *holder, animation).size();
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

// Lets an object that lay somewhere lie there until the thrower takes it. Otherwise it would begin
// to move to where it is thrown.
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

// Adds advice to a throw that misses: a region without friction, if that helps.
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

bool HasThrow(int object, double frame, const Animation& animation, const Project& project) {
  const std::vector<HolderSpan> spans = HoldersOf(project.held_objects[object], project.frames);
  const HolderSpan* holder = HolderAt(static_cast<int>(frame), spans);
  const bool keeps_it = holder && !holder->is_let_go;
  return !keeps_it && CaseOf(object, frame, animation, project).ok();
}

Result<ThrowReport> ThrowTo(const ThrowTarget& target, ThrowCase of,
                            std::shared_ptr<const Figure> figure, Project* project) {
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
  const Vec3 spot = target.spot + radius * Vec3::UnitZ();
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
  const AimedThrow& thrown = aimed.value();
  return ThrowReport{animation.regions[of.region].name,
                     thrown.release,
                     down,
                     thrown.path.velocity,
                     thrown.at_limit,
                     thrown.limit_hits,
                     aim.work()};
}

Result<MadeThrow> AimThrow(const ThrowTarget& target, double frame, const Animation& animation,
                           const Motion& motion, const Project& project) {
  Result<ThrowCase> of = CaseOf(target.object, frame, animation, project);
  if (!of.ok()) return of.error();
  MadeThrow made = {project, {}};
  SwingAnew(target, animation, motion, &of.value(), &made.project);
  const Result<ThrowReport> thrown = ThrowTo(target, of.value(), animation.figure, &made.project);
  if (!thrown.ok()) return thrown.error();
  made.report = thrown.value();
  return made;
}

}  // namespace hazumi::makers
