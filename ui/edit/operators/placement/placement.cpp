// What places the figure, and joints that inverse kinematics holds.

#include <algorithm>

#include "engine/timeline/placement_span.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

using Spans = std::vector<ProjectPlacement>;

// The entry that the parameter "index" counts out.
template <typename T>
Result<T*> EntryAt(const Parameters& p, const std::string& what, std::vector<T>* list) {
  const int index = p.integer("index"), num = static_cast<int>(list->size());
  if (index >= 0 && index < num) return &(*list)[index];
  return Refusal("index", "there is no " + what + " " + std::to_string(index) + "; there are " +
                              std::to_string(num) + ", counted from 0");
}

Result<Done> AddPlacement(Session* session, const Parameters& p) {
  return session->Edit("Place figure", [&](Project* project) -> Result<Done> {
    ProjectPlacement span;
    if (Result<Done> set = SetFields(p, &span); !set.ok()) return set;
    const bool is_said = span.kind != PlacementKind::kKeyed;
    return PutPlacement(std::move(span), is_said, &project->placements);
  });
}

// What is given of it. Only gravity ends in a landing.
Result<Done> ChangePlacement(const Parameters& p, ProjectPlacement* span) {
  Result<Done> set = SetFields(p, span);
  if (span->kind != PlacementKind::kGravity) span->landing_pin.clear();
  return set;
}

// In a drag spans are as they were when it began, so that those that gave way come back.
Result<Done> EditPlacement(Session* session, const Parameters& p) {
  return session->Edit(
      "Change placement",
      [&](Project* project) -> Result<Done> {
        Spans& spans = project->placements;
        const Document::State* start = session->document().drag_start(p.text("drag"));
        if (start) spans = start->project.placements;
        const Result<ProjectPlacement*> entry = EntryAt(p, "placement", &spans);
        if (!entry.ok()) return entry.error();
        ProjectPlacement span = *entry.value();
        Result<Done> changed = ChangePlacement(p, &span);
        if (!changed.ok()) return changed;
        spans.erase(spans.begin() + (entry.value() - spans.data()));
        // A span of keys that a file has stays one, unless it becomes one now.
        const bool is_said = p.text("kind") != hazumi::NameOf(PlacementKind::kKeyed);
        return PutPlacement(std::move(span), is_said, &spans);
      },
      p.text("drag"));
}

Result<Done> RemovePlacement(Session* session, const Parameters& p) {
  return session->Edit("Remove placement", [&](Project* project) -> Result<Done> {
    Spans& spans = project->placements;
    const Result<ProjectPlacement*> entry = EntryAt(p, "placement", &spans);
    if (!entry.ok()) return entry.error();
    spans.erase(spans.begin() + (entry.value() - spans.data()));
    return Done();
  });
}

Result<Done> AddHold(Session* session, const Parameters& p) {
  return session->Edit(
      "Hold joint",
      [&](Project* project) -> Result<Done> {
        ProjectHold hold;
        if (Result<Done> set = SetFields(p, &hold); !set.ok()) return set;
        project->holds.push_back(std::move(hold));
        return Done();
      },
      p.text("drag"));
}

Result<Done> SetHold(Session* session, const Parameters& p) {
  return session->Edit(
      "Change hold",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectHold*> hold = EntryAt(p, "hold", &project->holds);
        if (!hold.ok()) return hold.error();
        return SetFields(p, hold.value());
      },
      p.text("drag"));
}

Result<Done> RemoveHold(Session* session, const Parameters& p) {
  return session->Edit("Remove hold", [&](Project* project) -> Result<Done> {
    const Result<ProjectHold*> hold = EntryAt(p, "hold", &project->holds);
    if (!hold.ok()) return hold.error();
    project->holds.erase(project->holds.begin() + (hold.value() - project->holds.data()));
    return Done();
  });
}

const ParameterInfo kPlacement = {"index", kInteger, true, "which of them, counted from 0",
                                  Thing::kPlacement};
const ParameterInfo kHold = {"index", kInteger, true, "which of them, counted from 0",
                             Thing::kHold};

}  // namespace

std::vector<Operator> PlacementOperators() {
  return {
      {"placement.set", "Place figure",
       "Says what places the figure for some frames; what was said of them before gives way.",
       Requiring({"kind", "first", "last"}, FieldsOf<ProjectPlacement>()), AddPlacement},
      {"placement.edit", "Change placement",
       "Changes what is given of a span of placement; what is said of its frames gives way.",
       Joined({{kPlacement}, FieldsOf<ProjectPlacement>(), {kDrag}}), EditPlacement},
      {"placement.remove",
       "Remove placement",
       "Takes a span of placement away: the root's keys place the figure there.",
       {kPlacement},
       RemovePlacement},
      {"hold.add", "Hold joint", "Keeps a joint where it is by inverse kinematics.",
       Joined({Requiring({"joint", "first", "last"}, FieldsOf<ProjectHold>()), {kDrag}}), AddHold},
      {"hold.set", "Change hold", "Changes what is given of a hold.",
       Joined({{kHold}, FieldsOf<ProjectHold>(), {kDrag}}), SetHold},
      {"hold.remove", "Remove hold", "Takes a hold away.", {kHold}, RemoveHold}};
}

}  // namespace hazumi::edit
