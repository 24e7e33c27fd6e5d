#include "engine/exchange/content.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>

#include "engine/base/text.h"

namespace hazumi {
namespace {

constexpr std::string_view kBom = "\xEF\xBB\xBF";
constexpr std::string_view kFbxMagic = "Kaydara FBX Binary";

std::string_view AfterBlanks(std::string_view text) {
  if (text.starts_with(kBom)) text.remove_prefix(kBom.size());
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
    text.remove_prefix(1);
  return text;
}

// Whether the text begins with a word, in any case.
bool BeginsWith(std::string_view text, std::string_view lower_word) {
  return text.size() >= lower_word.size() &&
         std::equal(lower_word.begin(), lower_word.end(), text.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

bool Contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

bool IsFbxText(std::string_view text) {
  return (text.starts_with(";") && BeginsWith(AfterBlanks(text.substr(1)), "fbx")) ||
         Contains(text.substr(0, 4096), "FBXHeaderExtension:");
}

std::optional<CharacterFormat> Known(std::string_view bytes) {
  const std::string_view text = AfterBlanks(bytes);
  if (bytes.starts_with("glTF")) return CharacterFormat::kGlb;
  if (bytes.starts_with(kFbxMagic)) return CharacterFormat::kFbxBinary;
  if (BeginsWith(text, "hierarchy")) return CharacterFormat::kBvh;
  if (IsFbxText(text)) return CharacterFormat::kFbxText;
  if (text.starts_with("<") && Contains(text, "<COLLADA")) return CharacterFormat::kCollada;
  if (text.starts_with("{") && Contains(text, "\"asset\"")) return CharacterFormat::kGltf;
  return std::nullopt;
}

// What programs write that is not read, by how it begins.
struct Stranger {
  std::string_view beginning, name;
};
constexpr std::array<Stranger, 14> kStrangers = {{
    {"md5version", "an MD5 model"},
    {"ply", "a PLY mesh"},
    {"xof ", "a DirectX .x file"},
    {"blender", "a Blender file"},
    {"solid", "an STL mesh"},
    {"#usda", "a USD scene"},
    {"pxr-usdc", "a USD scene"},
    {"pk\x03\x04", "a ZIP archive"},
    {"\x1f\x8b", "a gzip archive"},
    {"\x89png", "a PNG picture"},
    {"\xff\xd8\xff", "a JPEG picture"},
    {"idst", "a Source model"},
    {"# blender", "an OBJ mesh"},
    {"version 1", "an SMD model"},
}};

std::string Resembles(std::string_view bytes) {
  const std::string_view text = AfterBlanks(bytes);
  for (const Stranger& stranger : kStrangers)
    if (BeginsWith(text, stranger.beginning)) return std::string(stranger.name);
  if (text.starts_with("{")) return "JSON, but not glTF 2.0 (it has no \"asset\")";
  if (text.starts_with("<")) return "XML, but not Collada";
  return "of a format that Hazumi does not know";
}

std::string SuffixOf(const std::string& file) {
  return LowerCase(std::filesystem::path(file).extension().string());
}

// ", although it is called .fbx" for names that promise one of our formats.
std::string DespiteItsName(const std::string& file) {
  const std::string suffix = SuffixOf(file);
  for (const char* ours : {".bvh", ".gltf", ".glb", ".fbx", ".dae"})
    if (suffix == ours) return ", although its name ends in " + suffix;
  return "";
}

}  // namespace

const char* FormatName(CharacterFormat format) {
  switch (format) {
    case CharacterFormat::kBvh:
      return "BVH";
    case CharacterFormat::kGltf:
      return "glTF";
    case CharacterFormat::kGlb:
      return "GLB";
    case CharacterFormat::kFbxBinary:
    case CharacterFormat::kFbxText:
      return "FBX";
    case CharacterFormat::kCollada:
      return "Collada";
    case CharacterFormat::kObj:
      return "OBJ";
  }
  return "";
}

Result<CharacterFormat> FormatOf(ReadUse use, std::string_view bytes, const std::string& file) {
  const bool is_thing = use == ReadUse::kThing;
  const auto refused = [&](const std::string& why) {
    const char* formats = is_thing
                              ? "glTF 2.0 (.gltf, .glb), FBX (.fbx), Collada (.dae) and OBJ (.obj)"
                              : "BVH (.bvh), glTF 2.0 (.gltf, .glb), FBX (.fbx) and Collada (.dae)";
    return Error{ErrorCode::kSyntax, file, "",
                 "is " + why + "; " + (is_thing ? "meshes are read from " : "Hazumi reads ") +
                     formats + ": export it as one of these"};
  };
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    return Error{
        ErrorCode::kSyntax, file, "",
        "is text in UTF-16, which Hazumi does not read; save it as UTF-8, by a text editor "
        "or by the program that it is from"};
  }
  const std::optional<CharacterFormat> format = Known(bytes);
  if (is_thing && format == CharacterFormat::kBvh) return refused("BVH, which has no meshes");
  if (format) return *format;
  if (AfterBlanks(bytes).empty()) return refused("empty");
  if (is_thing && SuffixOf(file) == ".obj") return CharacterFormat::kObj;
  return refused(Resembles(bytes) + DespiteItsName(file));
}

}  // namespace hazumi
