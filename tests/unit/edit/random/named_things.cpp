#include "tests/unit/edit/random/named_things.h"

#include "engine/project/edits/curves.h"
#include "engine/project/items.h"

namespace hazumi::test {

using edit::Session;

namespace {

template <typename List>
std::vector<std::string> NamesIn(const List& list) {
  std::vector<std::string> names;
  for (const auto& entry : list) names.push_back(entry.name);
  return names;
}

// Names of the items of a project that a thing means; nothing: it means no kind of items with
// names.
std::optional<std::vector<std::string>> NamesOfItems(Thing thing, const Project& project) {
  std::optional<std::vector<std::string>> names;
  const auto list = [&]<typename Item>(auto kind, const std::vector<Item>& items) {
    if constexpr (HasUniqueName<Item>) {
      if (kind.kThing == thing) names = NamesIn(items);
    }
  };
  ForEachItemList(list, project);
  return names;
}

}  // namespace

std::vector<std::string> NamesOf(Thing thing, const Session& session) {
  const Figure& figure = session.figure();
  const Project& project = session.project();
  if (const auto items = NamesOfItems(thing, project)) return *items;
  switch (thing) {
    case Thing::kJoint:
      return NamesIn(figure.groups());
    case Thing::kHinge:
      return NamesIn(figure.joints());
    case Thing::kJointOrHinge: {
      std::vector<std::string> names = NamesIn(figure.groups()), hinges = NamesIn(figure.joints());
      names.insert(names.end(), hinges.begin(), hinges.end());
      return names;
    }
    case Thing::kJointOrRoot: {
      std::vector<std::string> names = NamesIn(figure.groups());
      names.push_back(figure.root_name());
      return names;
    }
    case Thing::kCurve:
      return CurveNames(project);
    case Thing::kLink:
      return NamesIn(figure.links());
    case Thing::kSceneOrHeldObject: {
      std::vector<std::string> names = NamesIn(project.scene.objects);
      for (const std::string& held : NamesIn(project.held_objects)) names.push_back(held);
      return names;
    }
    case Thing::kSelectionSet:
      return NamesIn(project.selection_sets);
    default:
      return {};
  }
}

std::optional<size_t> CountOf(Thing thing, const Project& project) {
  std::optional<size_t> count;
  const auto of = [&]<typename Item>(auto kind, const std::vector<Item>& items) {
    if constexpr (!HasUniqueName<Item>) {
      if (kind.kThing == thing) count = items.size();
    }
  };
  ForEachItemList(of, project);
  return count;
}

namespace {

bool IsNamed(Thing thing) {
  return (thing >= Thing::kJoint && thing <= Thing::kLink) || thing == Thing::kSelectionSet ||
         thing == Thing::kSceneOrHeldObject || NamesOfItems(thing, Project());
}

}  // namespace

bool HasAny(Thing thing, const Session& session) {
  if (const auto count = CountOf(thing, session.project())) return *count > 0;
  return !IsNamed(thing) || !NamesOf(thing, session).empty();
}

}  // namespace hazumi::test
