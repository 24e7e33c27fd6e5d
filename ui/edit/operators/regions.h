#pragma once

// Internal: what the operators of regions share.

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

inline const ParameterInfo kOfRegion = {"region", ParameterKind::kText, true, "the region's name",
                                        Thing::kRegion};

// Friction factor of a new region of the editor: kLimpFriction, or kFallFriction for a whole body
// that is released and touches the scene.
inline constexpr double kLimpFriction = 0.8, kFallFriction = 0.96;
double StartFriction(const ProjectRegion& region, const Figure& figure);

// Leaves twists, cloth and fingers out of references to all that is beyond a joint, unless the
// joint is one of these itself.
void LeaveOutSmallParts(const Figure& figure, std::vector<JointRef>* refs);

// One undo step on the region of the parameter "region": action(project, region).
template <typename Action>
Result<Done> ChangeRegion(Session* session, const Parameters& p, const char* label, Action action) {
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

}  // namespace hazumi::edit
