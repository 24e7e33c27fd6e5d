#include "engine/exchange/bvh/bvh_names.h"

#include <map>
#include <set>

#include "engine/base/text.h"
#include "engine/exchange/bvh/bvh_scanner.h"

namespace hazumi {

std::string ChannelName(const BvhChannel& channel) {
  return std::string(1, "XYZ"[channel.axis]) + (channel.is_rotation ? "rotation" : "position");
}

std::optional<BvhChannel> ChannelNamed(std::string_view word) {
  for (int i = 0; i < 6; ++i) {
    const BvhChannel channel{0, i % 3, i >= 3};
    if (IsKeyword(word, LowerCase(ChannelName(channel)))) return channel;
  }
  return std::nullopt;
}

std::vector<RenamedBone> MakeNamesUnique(std::vector<Bone>* bones) {
  std::vector<RenamedBone> renamed;
  std::set<std::string> given, seen;
  std::map<std::string, int> last_number;
  for (const Bone& bone : *bones) given.insert(bone.name);
  for (size_t i = 0; i < bones->size(); ++i) {
    std::string& name = (*bones)[i].name;
    if (seen.insert(name).second) continue;
    renamed.push_back({i, name});
    int& number = last_number.try_emplace(name, 1).first->second;
    std::string unique;
    do {
      unique = name + "_" + std::to_string(++number);
    } while (given.contains(unique));
    given.insert(unique);
    name = unique;
  }
  return renamed;
}

}  // namespace hazumi
