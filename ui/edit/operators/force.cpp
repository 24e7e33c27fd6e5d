// Forces from outside.

#include <algorithm>
#include <cmath>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kForce = {"force", kText, true, "the force's name", Thing::kForce};

// Sets what is given of a force, and what its kind cannot do without.
Result<Done> SetOwnFields(const Session& session, const Parameters& p, ProjectForce* force) {
  const bool was_push = force->kind() == ForceKind::kPush;
  if (Result<Done> set = SetFields(p, force); !set.ok()) return set;
  if (ForcePointOf(force->action) && force->joint.empty()) force->joint = LikelyJoint(session);
  if (force->kind() == ForceKind::kPush) return Done();
  const int last = session.project().frames.last;
  if (was_push && !p.has("last")) force->last_frame = last;
  if (!p.has("last") && !p.has("first") && force->last_frame <= force->first_frame) {
    force->last_frame = std::max(last, force->first_frame + 1);
  }
  return Done();
}

Result<Done> AddForce(Session* session, const Parameters& p) {
  return session->Edit("Add force", [&](Project* project) -> Result<Done> {
    ProjectForce force;
    force.first_frame = project->frames.first;
    force.last_frame = project->frames.last;
    if (p.text("kind") == NameOf(ForceKind::kPush)) {
      force.first_frame = static_cast<int>(std::lround(session->frame()));
    }
    if (Result<Done> set = SetOwnFields(*session, p, &force); !set.ok()) return set;
    if (!p.has("name")) force.name = NameOf(force.kind());
    force.name = FreeName(force.name, project->forces);
    project->forces.push_back(std::move(force));
    return Done();
  });
}

Result<Done> SetForce(Session* session, const Parameters& p) {
  return session->Edit(
      "Change force",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectForce*> force = EntryNamed(p.text("force"), "force", &project->forces);
        if (!force.ok()) return force.error();
        if (Result<Done> set = SetOwnFields(*session, p, force.value()); !set.ok()) return set;
        if (p.has("name")) {
          force.value()->name = FreeName(force.value()->name, project->forces, force.value());
        }
        return Done();
      },
      p.text("drag"));
}

Result<Done> RemoveForce(Session* session, const Parameters& p) {
  return session->Edit("Remove force", [&](Project* project) -> Result<Done> {
    auto& forces = project->forces;
    const Result<ProjectForce*> force = EntryNamed(p.text("force"), "force", &forces);
    if (!force.ok()) return force.error();
    forces.erase(forces.begin() + (force.value() - forces.data()));
    return Done();
  });
}

}  // namespace

std::vector<Operator> ForceOperators() {
  return {{"force.add", "Add force",
           "Adds a force from outside, which regions of method exact feel. Not given: all frames, "
           "of a push the current one; the first selected joint.",
           Requiring({"kind"}, FieldsOf<ProjectForce>()), AddForce},
          {"force.set", "Change force",
           "Changes what is given of a force; what another kind needs is made up.",
           Joined({{kForce}, FieldsOf<ProjectForce>(), {kDrag}}), SetForce},
          {"force.remove", "Remove force", "Takes a force away.", {kForce}, RemoveForce}};
}

}  // namespace hazumi::edit
