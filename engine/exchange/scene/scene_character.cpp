#include "engine/exchange/scene/scene_character.h"

#include <filesystem>

#include "engine/base/utf8.h"
#include "engine/exchange/scene/character_parts.h"
#include "engine/exchange/scene/scene_skeleton.h"

namespace hazumi {
namespace {

// Names of the nodes above the first bone.
std::string NamesAbove(const SceneTree& tree, const SceneSkeleton& skeleton) {
  std::string names;
  const std::vector<int>& chain = skeleton.chains[0];
  for (size_t i = 0; i + 1 < chain.size(); ++i) {
    const SceneNode& node = tree.node(chain[i]);
    if (node.is_helper || node.name.empty()) continue;
    names += (names.empty() ? "" : "/") + ValidUtf8(node.name);
  }
  return names;
}

Result<Done> AddBones(const SceneTree& tree, const ReadChoice& choice, const std::string& file,
                      Character* character) {
  Result<SceneSkeleton> skeleton = FindSkeleton(tree, choice.character, file, &character->warnings);
  if (!skeleton.ok()) return skeleton.error();
  Result<std::vector<Clip>> clips =
      ReadClips(tree, skeleton.value(), choice.rate, file, &character->warnings);
  if (!clips.ok()) return clips.error();
  character->clips = std::move(clips).value();
  character->meshes = ReadMeshes(tree, skeleton.value(), &character->warnings);
  character->bones = std::move(skeleton.value().bones);
  character->above = NamesAbove(tree, skeleton.value());
  character->chosen = std::move(skeleton.value().chosen);
  character->others = std::move(skeleton.value().others);
  return Done{};
}

Result<Done> AddThing(const SceneTree& tree, const std::string& file, Character* character) {
  SceneSkeleton skeleton;
  skeleton.chains = {{0}};
  skeleton.bone_of_node.assign(tree.nodes.size(), -1);
  skeleton.is_apart.assign(tree.nodes.size(), 0);
  skeleton.bones.resize(1);
  skeleton.bones[0].name = "thing";
  character->meshes = ReadMeshes(tree, skeleton, &character->warnings);
  if (character->meshes.empty())
    return Error{ErrorCode::kSemantics, file, "", "has no mesh; export it with one"};
  for (SkinMesh& mesh : character->meshes) {
    for (SkinMesh::Bind& bind : mesh.binds)
      bind.inverse_bind = (tree[0].world * bind.inverse_bind).eval();
  }
  character->bones = std::move(skeleton.bones);
  return Done{};
}

}  // namespace

Result<Character> CharacterOf(ReadUse use, Scene scene, const ReadChoice& choice,
                              SceneFolder* folder, const std::string& file) {
  Character character;
  character.name = ValidUtf8(std::filesystem::path(file).stem().string());
  character.up = scene.up;
  character.metres_per_unit = scene.metres_per_unit;
  character.warnings = std::move(scene.warnings);
  const Result<SceneTree> tree = LookAtScene(scene, file);
  if (!tree.ok()) return tree.error();
  const Result<Done> added = use == ReadUse::kThing
                                 ? AddThing(tree.value(), file, &character)
                                 : AddBones(tree.value(), choice, file, &character);
  if (!added.ok()) return added.error();
  ReadMaterials(scene, folder, &character);
  return character;
}

}  // namespace hazumi
