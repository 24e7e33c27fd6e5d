// Dynamics regions, placement and holds.

#include <algorithm>

#include "engine/timeline/placement_span.h"
#include "ui/edit/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kRegion = {"region", kText, true, "the region's name", Thing::kRegion};
const ParameterInfo kIndex = {"index", kInteger, true, "which of them, counted from 0",
                              Thing::kHold};

bool IsTaken(const std::string& name, const Project& project) {
  return std::any_of(project.regions.begin(), project.regions.end(),
                     [&](const ProjectRegion& region) { return region.name == name; });
}

std::string FreeName(const std::string& wanted, const Project& project) {
  std::string name = wanted;
  for (int i = 2; IsTaken(name, project); ++i) name = wanted + " " + std::to_string(i);
  return name;
}

// "r_shoulder+" is that joint and all beyond it.
JointRef RefFrom(std::string name) {
  JointRef ref;
  ref.beyond = name.ends_with('+');
  if (ref.beyond) name.pop_back();
  ref.name = name;
  return ref;
}

// In a drag the region takes the place of the one before.
Result<Done> Add(Session* session, const Parameters& p) {
  const std::string merge = p.has("drag") ? "region.add " + p.text("drag") : "";
  return session->Edit(
      "Add dynamics region",
      [&](Project* project) -> Result<Done> {
        const Document::State* start = session->document().drag_start(merge);
        if (start) project->regions = start->project.regions;
        ProjectRegion region;
        region.name = FreeName(p.text("name", "region"), *project);
        region.first_frame = p.integer("first");
        region.last_frame = p.integer("last");
        std::vector<std::string> names = p.names("joints");
        if (!p.has("joints")) {
          names.assign(session->selected_joints().begin(), session->selected_joints().end());
        }
        for (const std::string& name : names) region.joints.push_back(RefFrom(name));
        region.friction.default_factor = p.number("friction", 0.8);
        project->regions.push_back(std::move(region));
        return Done();
      },
      merge);
}

// Runs on one region by its name.
template <typename Action>
Result<Done> Change(Session* session, const Parameters& p, const char* label, Action action) {
  return session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        const Result<ProjectRegion*> region =
            EntryNamed(p.text("region"), "region", &project->regions);
        if (!region.ok()) return region.error();
        return action(project, region.value());
      },
      p.text("drag"));
}

Result<Done> SetRegion(Session* session, const Parameters& p) {
  return Change(session, p, "Change region", [&](Project* project, ProjectRegion* region) {
    region->first_frame = p.integer("first", region->first_frame);
    region->last_frame = p.integer("last", region->last_frame);
    region->limit_tangents = p.yes("limit_tangents", region->limit_tangents);
    if (p.has("tolerance")) region->tolerance_deg = p.number("tolerance");
    if (p.has("joints")) {
      region->joints.clear();
      for (const std::string& name : p.names("joints")) region->joints.push_back(RefFrom(name));
    }
    if (p.has("name")) region->name = FreeName(p.text("name"), *project);
    if (!p.has("method")) return Result<Done>(Done());
    const Result<Method> method =
        ValueNamed<Method>(p.text("method"), "method", {Method::kPaper, Method::kExact}, &NameOf);
    if (!method.ok()) return Result<Done>(method.error());
    region->method = method.value();
    return Result<Done>(Done());
  });
}

// Of one joint, or of all that have none of their own. Without a factor a joint loses its own.
Result<Done> SetFriction(Session* session, const Parameters& p) {
  return Change(session, p, "Change friction", [&](Project*, ProjectRegion* region) {
    ProjectFriction& friction = region->friction;
    if (!p.has("joint")) {
      if (!p.has("factor")) return Result<Done>(Refusal("factor", "is missing"));
      friction.default_factor = p.number("factor");
      return Result<Done>(Done());
    }
    const auto own = std::find_if(friction.joints.begin(), friction.joints.end(),
                                  [&](const auto& entry) { return entry.name == p.text("joint"); });
    if (!p.has("factor")) {
      if (own != friction.joints.end()) friction.joints.erase(own);
    } else if (own != friction.joints.end()) {
      own->value = p.number("factor");
    } else {
      friction.joints.push_back({p.text("joint"), p.number("factor")});
    }
    return Result<Done>(Done());
  });
}

// The second part takes over where the first one ends.
Result<Done> Split(Session* session, const Parameters& p) {
  return Change(session, p, "Split region", [&](Project* project, ProjectRegion* region) {
    const int frame = p.integer("frame");
    if (frame <= region->first_frame || frame >= region->last_frame) {
      return Result<Done>(Refusal("frame", "must lie inside the region, between its ends"));
    }
    ProjectRegion second = *region;
    second.name = FreeName(region->name, *project);
    second.first_frame = region->last_frame = frame;
    project->regions.insert(project->regions.begin() + (region - project->regions.data()) + 1,
                            std::move(second));
    return Result<Done>(Done());
  });
}

Result<Done> Remove(Session* session, const Parameters& p) {
  return Change(session, p, "Remove region", [&](Project* project, ProjectRegion* region) {
    project->regions.erase(project->regions.begin() + (region - project->regions.data()));
    return Result<Done>(Done());
  });
}

// The joints of an animation's region become keys, one a frame, and the region goes.
Result<Done> BakeToKeys(Session* session, const Parameters& p) {
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  return Change(session, p, "Bake region to keys", [&](Project* project, ProjectRegion* region) {
    const size_t index = region - project->regions.data();
    const DynamicsRegion& baked = session->animation()->regions[index];
    if (baked.root) {
      return Result<Done>(Refusal("region", "a region that turns the root cannot become keys yet"));
    }
    for (const JointIndex j : baked.joints) {
      const std::string& name = session->figure().joint(j).name;
      ProjectCurve* curve = CurveNamed(name, session->figure(), project).value();
      std::erase_if(curve->keys, [&](const ProjectKey& key) {
        return key.frame >= baked.first_frame && key.frame <= baked.last_frame;
      });
      for (int frame = baked.first_frame; frame <= baked.last_frame; ++frame) {
        const MotionFrame& at = motion.value()->frames[frame - project->frames.first];
        ProjectKey key;
        key.frame = frame;
        key.value = at.q[j.value()] / kDegree;
        key.rate = at.after.qd[j.value()] / kDegree;
        PutKey(key, curve);
      }
    }
    project->regions.erase(project->regions.begin() + static_cast<long>(index));
    return Result<Done>(Done());
  });
}

// Taken out of the way of a new span of placement.
void MakeRoom(int first, int last, std::vector<ProjectPlacement>* spans) {
  std::vector<ProjectPlacement> kept;
  for (ProjectPlacement& span : *spans) {
    ProjectPlacement before = span, after = span;
    before.last_frame = std::min(span.last_frame, first);
    after.first_frame = std::max(span.first_frame, last);
    if (before.first_frame < before.last_frame) kept.push_back(before);
    if (after.first_frame < after.last_frame) kept.push_back(after);
  }
  *spans = std::move(kept);
}

Result<Done> Place(Session* session, const Parameters& p) {
  const Result<PlacementKind> kind = ValueNamed<PlacementKind>(
      p.text("kind"), "kind",
      {PlacementKind::kKeyed, PlacementKind::kPinned, PlacementKind::kGravity}, &NameOf);
  if (!kind.ok()) return kind.error();
  return session->Edit("Place figure", [&](Project* project) -> Result<Done> {
    ProjectPlacement span;
    span.kind = kind.value();
    span.first_frame = p.integer("first");
    span.last_frame = p.integer("last");
    span.pin = p.text("pin");
    span.landing_pin = p.text("landing_pin");
    MakeRoom(span.first_frame, span.last_frame, &project->placements);
    const auto later = [](const ProjectPlacement& a, const ProjectPlacement& b) {
      return a.first_frame < b.first_frame;
    };
    auto& spans = project->placements;
    if (span.kind != PlacementKind::kKeyed) {
      spans.insert(std::upper_bound(spans.begin(), spans.end(), span, later), span);
    }
    return Done();
  });
}

Result<Done> Hold(Session* session, const Parameters& p) {
  return session->Edit("Hold joint", [&](Project* project) -> Result<Done> {
    ProjectHold hold;
    hold.joint = p.text("joint");
    hold.orientation = p.yes("orientation");
    hold.first_frame = p.integer("first");
    hold.last_frame = p.integer("last");
    project->holds.push_back(std::move(hold));
    return Done();
  });
}

Result<Done> RemoveHold(Session* session, const Parameters& p) {
  return session->Edit("Remove hold", [&](Project* project) -> Result<Done> {
    const int index = p.integer("index");
    if (index < 0 || index >= static_cast<int>(project->holds.size())) {
      return Refusal("index", "there is no such hold");
    }
    project->holds.erase(project->holds.begin() + index);
    return Done();
  });
}

}  // namespace

std::vector<Operator> RegionOperators() {
  const ParameterInfo first = {"first", kInteger, true, "first frame"};
  const ParameterInfo last = {"last", kInteger, true, "last frame"};
  const ParameterInfo joints = {
      "joints", kNames, false,
      "joints, with + behind the name all beyond too; not given: the selected ones", Thing::kJoint};
  const ParameterInfo landing_pin = {
      "landing_pin", kText, false, "with gravity: the joint pinned after a landing", Thing::kJoint};
  return {{"region.add",
           "Add dynamics region",
           "Lets joints swing by their own inertia for some frames.",
           {{"name", kText, false, "its name"},
            first,
            last,
            joints,
            {"friction", kNumber, false, "factor of all joints, 0 to 1; 0.8", Thing::kShare},
            kDrag},
           Add},
          {"region.set",
           "Change region",
           "Changes what is given of a region.",
           {kRegion,
            {"name", kText, false, "a new name"},
            {"first", kInteger, false, "first frame"},
            {"last", kInteger, false, "last frame"},
            {"joints", kNames, false, "its joints instead", Thing::kJoint},
            {"method", kText, false, "exact or paper", "exact paper"},
            {"tolerance", kNumber, false, "greatest error of an angle in degrees"},
            {"limit_tangents", kYesNo, false, "curves after it stay inside the joints' limits"},
            kDrag},
           SetRegion},
          {"region.friction",
           "Change friction",
           "Sets the factor of speed that is left after 1/30 s.",
           {kRegion,
            {"factor", kNumber, false,
             "0 frozen, 1 no friction; not given: the joint has none of its own any more",
             Thing::kShare},
            {"joint", kText, false, "a joint or hinge; not given: all without one of their own",
             Thing::kJointOrHinge},
            kDrag},
           SetFriction},
          {"region.split",
           "Split region",
           "Makes two regions of one.",
           {kRegion, {"frame", kInteger, true, "where the second one begins"}},
           Split},
          {"region.remove", "Remove region", "Takes a region away.", {kRegion}, Remove},
          {"region.to_keys",
           "Bake region to keys",
           "Makes a key of each frame of a region and takes the region away.",
           {kRegion},
           BakeToKeys},
          {"placement.set",
           "Place figure",
           "Says what places the figure for some frames; what was said of them before gives way.",
           {{"kind", kText, true, "keyed, pinned or gravity", "pinned gravity keyed"},
            first,
            last,
            {"pin", kText, false, "the pinned joint", Thing::kJoint},
            landing_pin},
           Place},
          {"hold.add",
           "Hold joint",
           "Keeps a joint where it is by inverse kinematics.",
           {{"joint", kText, true, "a joint", Thing::kJoint},
            first,
            last,
            {"orientation", kYesNo, false, "true: also how it is turned"}},
           Hold},
          {"hold.remove", "Remove hold", "Takes a hold away.", {kIndex}, RemoveHold}};
}

}  // namespace hazumi::edit
