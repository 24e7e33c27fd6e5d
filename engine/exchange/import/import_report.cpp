#include <algorithm>
#include <string>

#include "engine/exchange/import/import_project.h"

namespace hazumi {

namespace {

constexpr size_t kNamed = 3;  // of the places that a warning is about

struct Group {
  std::vector<std::string> places;
  std::string message;
};

std::vector<Group> ByMessage(const std::vector<Warning>& warnings) {
  std::vector<Group> groups;
  for (const Warning& warning : warnings) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return group.message == warning.message;
    });
    if (same == groups.end()) {
      groups.push_back({{warning.place}, warning.message});
    } else {
      same->places.push_back(warning.place);
    }
  }
  return groups;
}

std::string PlacesOf(const Group& group) {
  std::string text;
  const size_t num = group.places.size();
  for (size_t i = 0; i < std::min(num, kNamed); ++i) text += (i ? ", " : "") + group.places[i];
  return num <= kNamed ? text : text + " and " + std::to_string(num - kNamed) + " more";
}

}  // namespace

std::vector<Warning> Shortened(const std::vector<Warning>& warnings, size_t most) {
  if (most == 0) return warnings;
  const std::vector<Group> groups = ByMessage(warnings);
  std::vector<Warning> few;
  size_t num_left = warnings.size();
  for (size_t i = 0; i < std::min(most, groups.size()); ++i) {
    few.push_back({PlacesOf(groups[i]), groups[i].message});
    num_left -= groups[i].places.size();
  }
  if (num_left > 0) {
    few.push_back(
        {"import", "and " + std::to_string(num_left) + " more; --all-warnings says them"});
  }
  return few;
}

}  // namespace hazumi
