#include "ui/edit/document/give_ids.h"

#include <set>

namespace hazumi::edit {

void GiveIds(Project* project, int* next) {
  std::set<ItemId> given;
  const auto give = [&](auto* items) {
    for (auto& item : *items) {
      ItemId& id = item.identity.id;
      if (id.is_valid() && given.insert(id).second) continue;
      while (given.contains(ItemId(*next))) ++*next;
      id = ItemId((*next)++);
      given.insert(id);
    }
  };
  give(&project->regions);
  give(&project->placements);
  give(&project->holds);
  give(&project->held_objects);
  give(&project->scene.objects);
  give(&project->markers);
}

}  // namespace hazumi::edit
