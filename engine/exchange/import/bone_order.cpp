#include "engine/exchange/import/bone_order.h"

namespace hazumi {

void Reorder(const std::vector<int>& from, Character* character) {
  std::vector<int> to(from.size());
  for (size_t i = 0; i < from.size(); ++i) to[static_cast<size_t>(from[i])] = static_cast<int>(i);
  const auto taken = [&](const auto& list) {
    auto ordered = list;
    for (size_t i = 0; i < from.size(); ++i) ordered[i] = list[static_cast<size_t>(from[i])];
    return ordered;
  };
  character->bones = taken(character->bones);
  for (Bone& bone : character->bones) {
    if (bone.parent >= 0) bone.parent = to[static_cast<size_t>(bone.parent)];
  }
  for (Clip& clip : character->clips) clip.tracks = taken(clip.tracks);
  for (SkinMesh& mesh : character->meshes) {
    for (SkinMesh::Bind& bind : mesh.binds) bind.bone = to[static_cast<size_t>(bind.bone)];
  }
}

void PutParentsFirst(Character* character) {
  const size_t num = character->bones.size();
  std::vector<int> order;
  std::vector<char> is_in(num, 0);
  const auto add = [&](int b) {
    std::vector<int> above;
    for (; b >= 0 && !is_in[static_cast<size_t>(b)];
         b = character->bones[static_cast<size_t>(b)].parent)
      above.push_back(b);
    for (; !above.empty(); above.pop_back()) {
      is_in[static_cast<size_t>(above.back())] = 1;
      order.push_back(above.back());
    }
  };
  for (size_t b = 0; b < num; ++b) add(static_cast<int>(b));
  Reorder(order, character);
}

}  // namespace hazumi
