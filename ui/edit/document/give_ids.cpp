#include <vector>

#include "engine/project/items.h"
#include "ui/edit/document/document.h"

namespace hazumi::edit {

namespace {

template <typename Action>
void ForEachIdentity(Project* project, Action&& action) {
  const auto all = [&](auto& items) {
    for (auto& item : items) action(&item.identity.id);
  };
  ForEachItemList([&](auto, auto& items) { all(items); }, *project);
  for (ProjectRegion& region : project->regions) all(region.drives);
  for (ProjectHeldObject& object : project->held_objects) all(object.holders);
}

}  // namespace

void GiveIds(Project* project, int* next) {
  std::vector<char> is_taken(static_cast<size_t>(*next), 0);  // by id
  std::vector<ItemId*> without;
  ForEachIdentity(project, [&](ItemId* id) {
    if (!id->is_valid()) return without.push_back(id);
    const auto value = static_cast<size_t>(id->value());
    if (value >= is_taken.size()) is_taken.resize(value + 1, 0);
    if (is_taken[value]) return without.push_back(id);
    is_taken[value] = 1;
  });
  for (ItemId* id : without) {
    while (static_cast<size_t>(*next) < is_taken.size() && is_taken[*next]) ++*next;
    *id = ItemId((*next)++);
  }
}

}  // namespace hazumi::edit
