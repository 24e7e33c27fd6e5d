#include "engine/exchange/assimp/scene_read.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <filesystem>

#include "engine/base/utf8.h"
#include "engine/exchange/assimp/gltf_repair.h"
#include "engine/exchange/assimp/scene_axes.h"
#include "engine/exchange/assimp/scene_clips.h"
#include "engine/exchange/assimp/scene_files.h"
#include "engine/exchange/assimp/scene_materials.h"
#include "engine/exchange/assimp/scene_meshes.h"
#include "engine/exchange/assimp/scene_skeleton.h"

namespace hazumi {
namespace {

// assimp's reader of a format, and the suffix by which that recognizes it.
struct AssimpFormat {
  const char* importer = nullptr;  // none: assimp is not asked
  const char* suffix = "";
};

AssimpFormat AssimpFormatOf(CharacterFormat format) {
  switch (format) {
    case CharacterFormat::kGltf:
      return {"glTF2 Importer", ".gltf"};
    case CharacterFormat::kGlb:
      return {"glTF2 Importer", ".glb"};
    case CharacterFormat::kFbxBinary:
    case CharacterFormat::kFbxText:
      return {"Autodesk FBX Importer", ".fbx"};
    case CharacterFormat::kCollada:
      return {"Collada Importer", ".dae"};
    case CharacterFormat::kObj:
      return {"Wavefront Object Importer", ".obj"};
    case CharacterFormat::kBvh:
      break;
  }
  return {};
}

bool IsGltf(CharacterFormat format) {
  return format == CharacterFormat::kGltf || format == CharacterFormat::kGlb;
}
bool IsFbx(CharacterFormat format) {
  return format == CharacterFormat::kFbxBinary || format == CharacterFormat::kFbxText;
}

// Leaves one reader: none of the others, some of which crash on broken files, may try.
void KeepOnly(const char* name, Assimp::Importer* importer) {
  for (size_t i = importer->GetImporterCount(); i-- > 0;) {
    if (std::strcmp(importer->GetImporterInfo(i)->mName, name) != 0)
      importer->UnregisterLoader(importer->GetImporter(i));
  }
}

void SetProperties(Assimp::Importer* importer) {
  // Kept apart and multiplied in ClipSampler: when folded, animations of 5.2.5 still name them.
  importer->SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
  importer->SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer->SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
}

Error CannotRead(const std::string& file, CharacterFormat format, const std::string& why,
                 const SceneFiles& files) {
  std::string message = std::string("cannot be read as ") + FormatName(format) + " (" +
                        ValidUtf8(why.empty() ? "no reason given" : why) + ")";
  if (!files.refused().empty()) {
    return {ErrorCode::kSyntax, file, "",
            message + ": " + ValidUtf8(files.refused()[0]) +
                " is missing or lies outside the file's folder; put it beside the file, or embed "
                "it"};
  }
  return {ErrorCode::kSyntax, file, "",
          message + "; the file is probably broken: export it again, or in another format"};
}

// Materials of no mesh: assimp adds one for meshes without, whether there are such or not.
void DropUnused(Character* character) {
  std::vector<int> kept(character->materials.size(), -1);
  std::vector<Material> materials;
  for (SkinMesh& mesh : character->meshes) {
    if (mesh.material < 0) continue;
    int& index = kept[static_cast<size_t>(mesh.material)];
    if (index < 0) {
      index = static_cast<int>(materials.size());
      materials.push_back(character->materials[static_cast<size_t>(mesh.material)]);
    }
    mesh.material = index;
  }
  character->materials = std::move(materials);
}

void TakeBodies(const GltfNotes& notes, Character* character) {
  for (Bone& bone : character->bones) {
    const auto body = notes.bodies.find(bone.name);
    if (body != notes.bodies.end()) bone.body = body->second;
  }
  for (const std::string& name : notes.damaged) {
    character->warnings.push_back({"node " + name,
                                   "its shape and mass cannot be read from its"
                                   " extras; they are guessed"});
  }
}

Result<Character> Convert(CharacterFormat format, aiScene* scene, const GltfNotes& notes,
                          SceneFiles* files, const std::string& path, Character character) {
  character.name = ValidUtf8(std::filesystem::path(path).stem().string());
  TakeAxesAndUnit(format, scene, &character);
  const Result<SceneTree> tree = FlattenScene(*scene, path);
  if (!tree.ok()) return tree.error();
  Result<SceneSkeleton> skeleton = FindSkeleton(tree.value(), path, &character.warnings);
  if (!skeleton.ok()) return skeleton.error();
  if (notes.num_splines > 0) {
    character.warnings.push_back(
        {"clips", std::to_string(notes.num_splines) +
                      " channels are cubic splines; they are read as straight between their keys"});
  }
  Result<std::vector<Clip>> clips = ReadClips(*scene, tree.value(), skeleton.value(), IsFbx(format),
                                              notes.stepped, path, &character.warnings);
  if (!clips.ok()) return clips.error();
  character.clips = std::move(clips).value();
  Result<std::vector<SkinMesh>> meshes =
      ReadMeshes(*scene, tree.value(), skeleton.value(), path, &character.warnings);
  if (!meshes.ok()) return meshes.error();
  character.meshes = std::move(meshes).value();
  ReadMaterials(*scene, files, &character);
  DropUnused(&character);
  character.bones = std::move(skeleton.value().bones);
  TakeBodies(notes, &character);
  return character;
}

// All meshes on one bone, which is the scene's root.
Result<Character> ConvertThing(CharacterFormat format, aiScene* scene, SceneFiles* files,
                               const std::string& path, Character character) {
  character.name = ValidUtf8(std::filesystem::path(path).stem().string());
  TakeAxesAndUnit(format, scene, &character);
  const Result<SceneTree> tree = FlattenScene(*scene, path);
  if (!tree.ok()) return tree.error();
  const size_t num_nodes = tree.value().nodes.size();
  SceneSkeleton skeleton;
  skeleton.chains = {{0}};
  skeleton.bone_of_node.assign(num_nodes, -1);
  skeleton.is_apart.assign(num_nodes, 0);
  skeleton.bones.resize(1);
  skeleton.bones[0].name = "thing";
  Result<std::vector<SkinMesh>> meshes =
      ReadMeshes(*scene, tree.value(), skeleton, path, &character.warnings);
  if (!meshes.ok()) return meshes.error();
  if (meshes.value().empty()) {
    return Error{ErrorCode::kSemantics, path, "", "has no mesh; export it with one"};
  }
  character.meshes = std::move(meshes).value();
  for (SkinMesh& mesh : character.meshes) {
    for (SkinMesh::Bind& bind : mesh.binds) {
      bind.inverse_bind = (tree.value().nodes[0].world * bind.inverse_bind).eval();
    }
  }
  ReadMaterials(*scene, files, &character);
  DropUnused(&character);
  character.bones = std::move(skeleton.bones);
  return character;
}

// glTF as assimp reads it correctly, and what it will not say.
Result<GltfNotes> Prepare(const std::string& path, SceneFiles* files,
                          std::vector<Warning>* warnings) {
  Result<GltfDocument> document = ParseGltf(files->main_bytes(), path);
  if (!document.ok()) return document.error();
  const Result<Done> repaired = RepairGltf(&document.value(), files, path, warnings);
  if (!repaired.ok()) return repaired.error();
  files->SetMainBytes(GltfBytes(document.value()));
  return NotesOf(document.value());
}

}  // namespace

Result<Character> ReadScene(CharacterFormat format, ReadUse use, std::string bytes,
                            const std::string& path) {
  const AssimpFormat known = AssimpFormatOf(format);
  auto* files = new SceneFiles(std::move(bytes), path, known.suffix);
  Assimp::Importer importer;
  importer.SetIOHandler(files);  // which then owns it
  if (!known.importer) return CannotRead(path, format, "this build has no reader of it", *files);
  GltfNotes notes;
  Character character;
  if (IsGltf(format)) {
    Result<GltfNotes> prepared = Prepare(path, files, &character.warnings);
    if (!prepared.ok()) return prepared.error();
    notes = std::move(prepared).value();
  }
  KeepOnly(known.importer, &importer);
  SetProperties(&importer);
  // Not JoinIdenticalVertices: in 5.2.5 it mixes up weights.
  importer.ReadFile(files->main_name(),
                    aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals);
  const std::string why = importer.GetErrorString();
  aiScene* scene = importer.GetOrphanedScene();
  if (!scene || !scene->mRootNode) return CannotRead(path, format, why, *files);
  if (use == ReadUse::kThing) {
    return ConvertThing(format, scene, files, path, std::move(character));
  }
  return Convert(format, scene, notes, files, path, std::move(character));
}

}  // namespace hazumi
