#include "engine/project/edits/key_selection.h"

#include "engine/project/edits/curves.h"
#include "engine/project/edits/keys.h"

namespace hazumi {

bool Contains(const KeySelection& keys, const std::string& curve, double frame) {
  const auto entry = keys.find(curve);
  return entry != keys.end() && entry->second.contains(frame);
}

size_t NumKeys(const KeySelection& keys) {
  size_t sum = 0;
  for (const auto& [curve, frames] : keys) sum += frames.size();
  return sum;
}

size_t BytesOf(const KeySelection& keys) {
  constexpr size_t kNode = 4 * sizeof(void*);  // of a set or map, beside its value
  return NumKeys(keys) * (kNode + sizeof(double)) +
         keys.size() * (kNode + sizeof(KeySelection::value_type));
}

void DropMissing(const Project& project, KeySelection* keys) {
  for (auto& [name, frames] : *keys) {
    const ProjectCurve* curve = FindCurve(name, project);
    std::erase_if(frames, [&](double frame) { return !curve || !KeyOn(frame, *curve); });
  }
  std::erase_if(*keys, [](const auto& entry) { return entry.second.empty(); });
}

}  // namespace hazumi
