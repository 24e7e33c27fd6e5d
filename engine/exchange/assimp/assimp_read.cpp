#include "engine/exchange/assimp/assimp_read.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <optional>

#include "engine/base/utf8.h"
#include "engine/exchange/assimp/assimp_scene.h"
#include "engine/exchange/collada/collada_motions.h"
#include "engine/exchange/fbx/fbx_motions.h"
#include "engine/exchange/fbx/fbx_records.h"

namespace hazumi {
namespace {

// assimp's reader of a format, and the suffix by which that recognizes it.
struct AssimpFormat {
  const char* importer = nullptr;  // none: assimp is not asked
  const char* suffix = "";
};

AssimpFormat AssimpFormatOf(CharacterFormat format) {
  switch (format) {
    case CharacterFormat::kFbxBinary:
    case CharacterFormat::kFbxText:
      return {"Autodesk FBX Importer", ".fbx"};
    case CharacterFormat::kCollada:
      return {"Collada Importer", ".dae"};
    case CharacterFormat::kObj:
      return {"Wavefront Object Importer", ".obj"};
    case CharacterFormat::kBvh:
    case CharacterFormat::kGltf:
    case CharacterFormat::kGlb:
      break;
  }
  return {};
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
  importer->SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // not ids
  importer->SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
}

Error CannotRead(const std::string& file, CharacterFormat format, const std::string& why,
                 const SceneFolder& folder) {
  std::string message = std::string("cannot be read as ") + FormatName(format) + " (" +
                        ValidUtf8(why.empty() ? "no reason given" : why) + ")";
  if (!folder.refused().empty()) {
    return {ErrorCode::kSyntax, file, "",
            message + ": " + ValidUtf8(folder.refused()[0]) +
                " is missing or lies outside the file's folder; put it beside the file, or embed "
                "it"};
  }
  return {ErrorCode::kSyntax, file, "",
          message + "; the file is probably broken: export it again, or in another format"};
}

// assimp reads what FBX has been since 2011.
std::optional<Error> WhyTooOld(std::string_view bytes, const std::string& file) {
  constexpr int kOldest = 7100;
  const int version = FbxVersion(bytes);
  if (version == 0 || version >= kOldest) return std::nullopt;
  const std::string name =
      std::to_string(version / 1000) + "." + std::to_string(version / 100 % 10);
  return Error{ErrorCode::kSemantics, file, "",
               "is of version " + name +
                   " of FBX, which Hazumi does not read; save it as FBX 2011 or "
                   "later, by the program that it is from or by Autodesk's FBX Converter"};
}

}  // namespace

Result<Scene> ReadByAssimp(CharacterFormat format, std::string bytes, const std::string& path,
                           SceneFolder* folder) {
  const AssimpFormat known = AssimpFormatOf(format);
  if (!known.importer) return CannotRead(path, format, "this build has no reader of it", *folder);
  std::optional<FbxRecord> records;
  if (IsFbx(format)) {
    if (auto error = WhyTooOld(bytes, path)) return *error;
    records = ReadFbxRecords(bytes);
  }
  std::optional<std::string> collada;
  if (format == CharacterFormat::kCollada) collada = bytes;
  Assimp::Importer importer;
  auto* files = new AssimpFiles(std::move(bytes), path, known.suffix, folder);
  importer.SetIOHandler(files);  // which then owns it
  KeepOnly(known.importer, &importer);
  SetProperties(&importer);
  // Not JoinIdenticalVertices: in 5.2.5 it mixes up weights.
  importer.ReadFile(files->main_name(),
                    aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals);
  const std::string why = importer.GetErrorString();
  aiScene* read = importer.GetOrphanedScene();
  if (!read || !read->mRootNode) return CannotRead(path, format, why, *folder);
  Scene scene;
  TakeAxesAndUnit(format, read, &scene);
  if (Result<Done> added = AddAssimpScene(*read, IsFbx(format), path, &scene); !added.ok())
    return added.error();
  if (collada) TakeColladaMotions(*collada, &scene);
  if (records) {
    TakeFbxMotions(*records, &scene);
  } else if (IsFbx(format)) {
    scene.warnings.push_back(
        {"clips", "the curves between keys cannot be read; they are taken as straight"});
  }
  return scene;
}

}  // namespace hazumi
