#include "engine/project/address/item_addresses.h"

#include "engine/project/address/addressed_field.h"
#include "engine/project/items.h"

namespace hazumi {

std::vector<ItemAddress> ItemAddresses(const Project& project) {
  std::vector<ItemAddress> addresses;
  ForEachItemList(
      [&](auto kind, const auto& items) {
        const std::vector<std::string> names = ItemNames(items);
        for (size_t i = 0; i < items.size(); ++i) {
          if (!items[i].identity.id.is_valid()) continue;
          addresses.push_back(
              {items[i].identity.id, std::string(kind.kList) + "[" + names[i] + "]"});
        }
      },
      project);
  return addresses;
}

}  // namespace hazumi
