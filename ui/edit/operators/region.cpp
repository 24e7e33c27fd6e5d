// Dynamics regions.

#include <algorithm>
#include <cstdint>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/placements.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/keys/start_keys.h"
#include "ui/edit/operators/regions.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kKeyStart = {"key_start", kYesNo, false,
                                 "true: its joints get keys on its first frame, where their curves "
                                 "are, so that keys inside it do "
                                 "not change the way into it"};

// In a drag the region takes the place of the one before.
Result<Done> AddRegion(Session* session, const Parameters& p) {
  const std::string merge = p.has("drag") ? "region.add " + p.text("drag") : "";
  return session->Edit(
      "Add dynamics region",
      [&](Project* project) -> Result<Done> {
        const Document::State* start = session->document().drag_start(merge);
        if (start) {
          project->regions = start->project.regions;
          project->joints = start->project.joints;
          project->root = start->project.root;
        }
        ProjectRegion region;
        region.name = "region";
        region.limit_tangents = true;
        for (const std::string& name : session->selected_joints()) {
          region.joints.push_back({name, false, {}});
        }
        if (Result<Done> set = SetFields(p, &region); !set.ok()) return set.error();
        Resolve(session->figure(), &region.joints);
        LeaveOutSmallParts(session->figure(), &region.joints);
        if (!p.has("friction")) {
          region.friction.default_factor = StartFriction(region, session->figure());
        }
        region.name = FreeName(region.name, project->regions);
        project->regions.push_back(std::move(region));
        if (p.yes("key_start")) {
          KeyRegionStart(project->regions.back(), session->figure(), project);
        }
        return Done();
      },
      merge);
}

Result<Done> SetRegion(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Change region", [&](Project* project, ProjectRegion* region) {
    if (p.yes("as_project")) {
      region->method.reset();
      region->step_s.reset();
      region->tolerance_deg.reset();
    }
    Result<Done> set = SetFields(p, region);
    if (p.has("joints")) Resolve(session->figure(), &region->joints);
    if (p.has("name")) region->name = FreeName(region->name, project->regions, region);
    return set;
  });
}

// Of one joint, or of all that have none of their own. Without a factor a joint loses its own.
Result<Done> SetFriction(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Change friction", [&](Project*, ProjectRegion* region) {
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
Result<Done> SplitRegion(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Split region", [&](Project* project, ProjectRegion* region) {
    const int frame = p.integer("frame");
    if (frame <= region->first_frame || frame >= region->last_frame) {
      return Result<Done>(Refusal("frame", "must lie inside the region, between its ends"));
    }
    ProjectRegion second = *region;
    second.name = FreeName(region->name, project->regions);
    second.first_frame = region->last_frame = frame;
    project->regions.insert(project->regions.begin() + (region - project->regions.data()) + 1,
                            std::move(second));
    return Result<Done>(Done());
  });
}

Result<Done> RemoveRegion(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Remove region", [&](Project* project, ProjectRegion* region) {
    project->regions.erase(project->regions.begin() + (region - project->regions.data()));
    return Result<Done>(Done());
  });
}

void RemoveKeys(int first, int last, ProjectCurve* curve) {
  std::erase_if(curve->keys,
                [&](const ProjectKey& key) { return key.frame >= first && key.frame <= last; });
}

void KeyHinge(JointIndex hinge, const MotionFrame& at, ProjectCurve* curve) {
  ProjectKey key;
  key.frame = at.frame;
  key.value = ShortestDegrees(at.q[hinge.value()]);
  key.rate = ShortestDegrees(at.after.qd[hinge.value()]);
  PutKey(key, curve);
}

// Its angles; where it is follows from the placement, as before.
void KeyRoot(const MotionFrame& at, ProjectRoot* root) {
  const auto values = RootValues(at.X_WR, *root, at.frame);
  const auto rates = RootAngleRates(values, at.after.root_w);
  for (int i = kRootAngleZ; i < kNumRootCurves; ++i) {
    ProjectKey key;
    key.frame = at.frame;
    key.value = values[i];
    if (rates) key.rate = (*rates)[i - kRootAngleZ];
    PutKey(key, &root->curves[i]);
  }
}

// The last frame of a region and of the blend after it.
int LastFrameOf(const DynamicsRegion& region, int last) {
  const int64_t end = static_cast<int64_t>(region.last_frame) + region.blend_frames;
  return static_cast<int>(std::min<int64_t>(end, last));
}

// The joints of an animation's region, and the root if it turns it, become keys, one a frame, up to
// the end of the blend after it, and the region goes.
Result<Done> BakeRegionToKeys(Session* session, const Parameters& p) {
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  return ChangeRegion(
      session, p, "Bake region to keys", [&](Project* project, ProjectRegion* region) {
        const size_t index = region - project->regions.data();
        const DynamicsRegion& baked = session->animation()->regions[index];
        const auto first =
            motion.value()->frames.begin() + baked.first_frame - project->frames.first;
        const int last = LastFrameOf(baked, project->frames.last);
        const auto end = first + (last - baked.first_frame) + 1;
        for (const JointIndex j : baked.joints) {
          const std::string& name = session->figure().joint(j).name;
          ProjectCurve* curve = CurveNamed(name, session->figure(), project).value();
          RemoveKeys(baked.first_frame, last, curve);
          for (auto at = first; at != end; ++at) KeyHinge(j, *at, curve);
        }
        for (int i = kRootAngleZ; i < kNumRootCurves && baked.root; ++i) {
          RemoveKeys(baked.first_frame, last, &project->root.curves[i]);
        }
        for (auto at = first; at != end && baked.root; ++at) KeyRoot(*at, &project->root);
        project->regions.erase(project->regions.begin() + static_cast<long>(index));
        return Result<Done>(Done());
      });
}

}  // namespace

std::vector<Operator> RegionOperators() {
  return {{"region.add", "Add dynamics region",
           "Lets joints swing by their own inertia for some frames. Default: the selected joints; "
           "friction 0.8, of a whole body with its root that touches the scene 0.96.",
           Joined({Requiring({"first", "last"}, FieldsOf<ProjectRegion>()), {kKeyStart, kDrag}}),
           AddRegion},
          {"region.set", "Change region", "Changes what is given of a region.",
           Joined({{kOfRegion},
                   FieldsOf<ProjectRegion>(),
                   {{"as_project", kYesNo, false,
                     "true: method, step and tolerance are the project's again"},
                    kDrag}}),
           SetRegion},
          {"region.friction",
           "Change friction",
           "Sets the factor of speed that is left after 1/30 s.",
           {kOfRegion,
            {"factor",
             kNumber,
             false,
             "0 frozen, 1 no friction; not given: the joint has none of its own any more",
             {},
             "",
             "",
             kShare},
            {"joint", kText, false, "a joint or hinge; not given: all without one of their own",
             Thing::kJointOrHinge},
            kDrag},
           SetFriction},
          {"region.split",
           "Split region",
           "Makes two regions of one.",
           {kOfRegion, {"frame", kInteger, true, "where the second one begins"}},
           SplitRegion},
          {"region.remove", "Remove region", "Takes a region away.", {kOfRegion}, RemoveRegion},
          {"region.to_keys",
           "Bake region to keys",
           "Makes a key of each frame of a region and takes the region away.",
           {kOfRegion},
           BakeRegionToKeys}};
}

}  // namespace hazumi::edit
