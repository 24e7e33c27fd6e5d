// fuzz_seeds BVH_FOLDER OUT: answers of the reader to start from, into OUT/character: of each BVH
// clip that can be read, of one with a mesh, and of a refusal.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/exchange/bvh/bvh_file.h"
#include "engine/exchange/character/character_bytes.h"

namespace {

namespace fs = std::filesystem;
using hazumi::Character;
using hazumi::Result;

void Write(const fs::path& path, const Result<Character>& character) {
  std::ofstream(path, std::ios::binary) << hazumi::CharacterToBytes(character);
}

// A triangle on the first bone.
void AddMesh(Character* character) {
  hazumi::SkinMesh mesh;
  mesh.name = "mesh";
  mesh.binds.resize(1);
  mesh.positions = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}};
  mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  mesh.bind_indices.assign(3, {0, 0, 0, 0});
  mesh.weights.assign(3, {1.0f, 0, 0, 0});
  mesh.triangles = {{0, 1, 2}};
  character->meshes = {mesh};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const fs::path out = fs::path(argv[2]) / "character";
  fs::create_directories(out);
  int num_read = 0;
  for (const auto& entry : fs::directory_iterator(argv[1])) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    Result<Character> character = hazumi::ReadBvh(text, entry.path().filename());
    if (!character.ok()) continue;
    ++num_read;
    Write(out / entry.path().filename(), character);
    Character with_mesh = character.value();
    AddMesh(&with_mesh);
    Write(out / (entry.path().filename().string() + "_mesh"), with_mesh);
  }
  Write(out / "refused", hazumi::Error{hazumi::ErrorCode::kSyntax, "a.fbx", "line 3", "is broken"});
  std::printf("%d clips\n", num_read);
  return num_read > 0 ? 0 : 1;
}
