// Forces from outside.

#include <algorithm>
#include <cmath>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kForce = {"force", kText, true, "the force's name", Thing::kForce};

// A breeze; a pull to a place one metre ahead; a push from behind.
ProjectForce NewForce(const Session& session) {
  ProjectForce force;
  force.velocity_m_s = Vec3(3.0, 0.0, 0.0);
  force.to_m = Vec3(1.0, 0.0, 1.0);
  force.force_n = 40.0;
  force.radius_m = 0.5;
  force.impulse_n_s = Vec3(5.0, 0.0, 0.0);
  force.first_frame = session.project().frames.first;
  force.last_frame = session.project().frames.last;
  return force;
}

// The force as one of another kind: a new one, but for what both kinds have in the file. What only
// the kind before had is no part of the file, and so of no use: a project that is opened again has
// to become the same.
ProjectForce OfAnotherKind(const ProjectForce& before, ForceKind kind, const Session& session) {
  ProjectForce force = NewForce(session);
  force.kind = kind;
  force.name = before.name;
  force.first_frame = before.first_frame;
  force.extra = before.extra;
  force.identity = before.identity;
  if (before.kind != ForceKind::kPush) force.last_frame = before.last_frame;
  if (!ActsAtPoint(before.kind) || !ActsAtPoint(kind)) return force;
  force.joint = before.joint;
  force.offset_m = before.offset_m;
  return force;
}

// Resets fields that the file does not say of this kind: a project that is opened again has to be
// the same.
void DropHidden(ProjectForce* force) {
  const ProjectForce none;
  if (force->kind != ForceKind::kWind) {
    force->velocity_m_s = none.velocity_m_s;
    force->density_kg_m3 = none.density_kg_m3;
  }
  if (!ActsAtPoint(force->kind)) {
    force->joint = none.joint;
    force->offset_m = none.offset_m;
  }
  if (force->kind != ForceKind::kAttract) {
    force->to_m = none.to_m;
    force->force_n = none.force_n;
    force->radius_m = none.radius_m;
  }
  if (force->kind == ForceKind::kPush) {
    force->last_frame = none.last_frame;
  } else {
    force->impulse_n_s = none.impulse_n_s;
  }
}

// Sets what is given of a force, and what its kind cannot do without.
Result<Done> SetOwnFields(const Session& session, const Parameters& p, ProjectForce* force) {
  const ForceKind before = force->kind;
  ProjectForce changed = *force;
  if (Result<Done> set = SetFields(p, &changed); !set.ok()) return set;
  if (changed.kind != before) {
    changed = OfAnotherKind(*force, changed.kind, session);
    if (Result<Done> set = SetFields(p, &changed); !set.ok()) return set;
  }
  *force = std::move(changed);
  if (ActsAtPoint(force->kind) && force->joint.empty()) force->joint = LikelyJoint(session);
  const ProjectFrames& all = session.project().frames;
  if (force->kind != ForceKind::kPush && !p.has("last") && !p.has("first") &&
      force->last_frame <= force->first_frame) {
    force->last_frame = std::max(all.last, force->first_frame + 1);
  }
  DropHidden(force);
  return Done();
}

Result<Done> AddForce(Session* session, const Parameters& p) {
  return session->Edit("Add force", [&](Project* project) -> Result<Done> {
    ProjectForce force = NewForce(*session);
    if (p.text("kind") == NameOf(ForceKind::kPush)) {
      force.first_frame = static_cast<int>(std::lround(session->frame()));
    }
    if (Result<Done> set = SetOwnFields(*session, p, &force); !set.ok()) return set;
    if (!p.has("name")) force.name = NameOf(force.kind);
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
           "Adds wind, a pull towards a place, or a push, which regions of method exact feel. Not "
           "given: all frames, of a push the current one; the first selected joint.",
           Requiring({"kind"}, FieldsOf<ProjectForce>()), AddForce},
          {"force.set", "Change force",
           "Changes what is given of a force; what another kind needs is made up.",
           Joined({{kForce}, FieldsOf<ProjectForce>(), {kDrag}}), SetForce},
          {"force.remove", "Remove force", "Takes a force away.", {kForce}, RemoveForce}};
}

}  // namespace hazumi::edit
