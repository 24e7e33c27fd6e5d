#pragma once

// The kinds of items of a project: entries of its lists that have an identity. A kind is declared
// once, here; who handles all kinds (ids, undo's changed frames, what keys carry along, options of
// forms) goes through ForEachItemList.

#include <tuple>
#include <type_traits>

#include "engine/project/fields/field.h"
#include "engine/project/project.h"

namespace hazumi {

// Declaration of a kind: the operator that changes an item and its parameter that says which, what
// parameters name, and the list in a file and in a project. An item with first_frame and last_frame
// is a span; an item of another kind has the frames that ForEachFrame visits. A kind with a title
// has operators that add and remove, a list in the scene's properties and a menu of these. A kind
// with a heading or a title is listed in the outliner.
template <typename Item>
struct ItemKind;

template <>
struct ItemKind<ProjectRegion> {
  static constexpr const char* kSet = "region.set";
  static constexpr const char* kParameter = "region";
  static constexpr Thing kThing = Thing::kRegion;
  static constexpr const char* kList = "regions";
  static auto& In(auto& project) { return project.regions; }
};
template <>
struct ItemKind<ProjectPlacement> {
  static constexpr const char* kSet = "placement.edit";
  static constexpr const char* kParameter = "index";
  static constexpr Thing kThing = Thing::kPlacement;
  static constexpr const char* kList = "placements";
  static auto& In(auto& project) { return project.placements; }
};
template <>
struct ItemKind<ProjectHold> {
  static constexpr const char* kSet = "hold.set";
  static constexpr const char* kParameter = "index";
  static constexpr Thing kThing = Thing::kHold;
  static constexpr const char* kList = "holds";
  static auto& In(auto& project) { return project.holds; }
};
template <>
struct ItemKind<ProjectHeldObject> {
  static constexpr const char* kHeading = "Held objects";
  static constexpr const char* kSet = "held.set";
  static constexpr const char* kParameter = "object";
  static constexpr Thing kThing = Thing::kHeldObject;
  static constexpr const char* kList = "held_objects";
  static auto& In(auto& project) { return project.held_objects; }
  // Frames in which the object is taken and let go.
  static void ForEachFrame(auto& object, auto&& action) {
    if (object.release_frame) action(*object.release_frame);
    for (auto& holder : object.holders) {
      action(holder.first_frame);
      if (holder.last_frame) action(*holder.last_frame);
    }
  }
};
template <>
struct ItemKind<ProjectSceneObject> {
  static constexpr const char* kHeading = "Scene";
  static constexpr const char* kSet = "object.set";
  static constexpr const char* kParameter = "object";
  static constexpr Thing kThing = Thing::kObject;
  static constexpr const char* kList = "scene.objects";
  static auto& In(auto& project) { return project.scene.objects; }
  static void ForEachFrame(auto&, auto&&) {}
};
template <>
struct ItemKind<ProjectMarker> {
  static constexpr const char* kSet = "";
  static constexpr const char* kParameter = "index";
  static constexpr Thing kThing = Thing::kMarker;
  static constexpr const char* kList = "markers";
  static auto& In(auto& project) { return project.markers; }
  static void ForEachFrame(auto& marker, auto&& action) { action(marker.frame); }
};
template <>
struct ItemKind<ProjectForce> {
  static constexpr const char* kTitle = "Forces";
  static constexpr const char* kAdd = "force.add";
  static constexpr const char* kSet = "force.set";
  static constexpr const char* kRemove = "force.remove";
  static constexpr const char* kParameter = "force";
  static constexpr Thing kThing = Thing::kForce;
  static constexpr const char* kList = "forces";
  static auto& In(auto& project) { return project.forces; }
};
template <>
struct ItemKind<ProjectConstraint> {
  static constexpr const char* kTitle = "Constraints";
  static constexpr const char* kAdd = "constraint.add";
  static constexpr const char* kSet = "constraint.set";
  static constexpr const char* kRemove = "constraint.remove";
  static constexpr const char* kParameter = "constraint";
  static constexpr Thing kThing = Thing::kConstraint;
  static constexpr const char* kList = "constraints";
  static auto& In(auto& project) { return project.constraints; }
};
template <>
struct ItemKind<ProjectFill> {
  static constexpr const char* kTitle = "Fills";
  static constexpr const char* kAdd = "fill.add";
  static constexpr const char* kSet = "fill.set";
  static constexpr const char* kRemove = "fill.remove";
  static constexpr const char* kParameter = "fill";
  static constexpr Thing kThing = Thing::kFill;
  static constexpr const char* kList = "fills";
  static auto& In(auto& project) { return project.fills; }
};
template <>
struct ItemKind<ProjectGoal> {
  static constexpr const char* kTitle = "Goals";
  static constexpr const char* kAdd = "goal.add";
  static constexpr const char* kSet = "goal.set";
  static constexpr const char* kRemove = "goal.remove";
  static constexpr const char* kParameter = "goal";
  static constexpr Thing kThing = Thing::kGoal;
  static constexpr const char* kList = "goals";
  static auto& In(auto& project) { return project.goals; }
  static void ForEachFrame(auto& goal, auto&& action) { action(goal.frame); }
};

using ItemTypes =
    std::tuple<ProjectRegion, ProjectPlacement, ProjectHold, ProjectHeldObject, ProjectSceneObject,
               ProjectMarker, ProjectForce, ProjectConstraint, ProjectFill, ProjectGoal>;

// Calls action(kind, list of each project ...) for each kind; `kind` is an ItemKind<Item>. Without
// projects: action(kind).
template <typename Action, typename... Projects>
void ForEachItemList(Action&& action, Projects&... projects) {
  const auto each = [&]<typename Item>(const Item*) {
    action(ItemKind<Item>(), ItemKind<Item>::In(projects)...);
  };
  const auto all = [&]<typename... Items>(const std::tuple<Items...>*) {
    (each(static_cast<const Items*>(nullptr)), ...);
  };
  all(static_cast<const ItemTypes*>(nullptr));
}

template <typename Item>
concept HasTitle = requires {
  ItemKind<Item>::kTitle;
};

// Heading of a kind in the outliner; null: it is not listed there.
template <typename Item>
constexpr const char* HeadingOf() {
  if constexpr (requires { ItemKind<Item>::kHeading; }) return ItemKind<Item>::kHeading;
  if constexpr (HasTitle<Item>) return ItemKind<Item>::kTitle;
  return nullptr;
}

// An item that messages and parameters call by a name of its own; others go by their number.
template <typename Item>
concept HasUniqueName = requires(Item item) {
  item.name;
}
&&!std::is_same_v<Item, ProjectMarker>;

// An item from a first to a last frame, half open.
template <typename Item>
concept SpanItem = requires(Item item) {
  item.first_frame;
  item.last_frame;
  requires !requires { item.last_frame.has_value(); };
};
// Whether its first frame alone counts.
template <SpanItem Item>
bool IsOneFrame(const Item& item) {
  if constexpr (std::is_same_v<Item, ProjectForce>) return item.kind() == ForceKind::kPush;
  return false;
}

}  // namespace hazumi
