#include <assimp/MemoryIOWrapper.h>

#include <cstring>
#include <filesystem>
#include <optional>

#include "engine/exchange/assimp/assimp_scene.h"

namespace hazumi {

AssimpFiles::AssimpFiles(std::string bytes, const std::string& path, const std::string& suffix,
                         SceneFolder* folder)
    : bytes_(std::move(bytes)),
      main_name_(folder->path() + "/" + std::filesystem::path(path).stem().string() + suffix),
      folder_(folder) {}

bool AssimpFiles::Exists(const char* name) const {
  return name == main_name_ || folder_->Has(name);
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
  if (std::strchr(mode, 'w') || std::strchr(mode, 'a')) return nullptr;
  std::optional<std::string> contents;
  if (name != main_name_) contents = folder_->Contents(name);
  if (name != main_name_ && !contents) return nullptr;
  const std::string& bytes = contents ? *contents : bytes_;
  auto* copy = new uint8_t[bytes.size() + 1]();
  std::memcpy(copy, bytes.data(), bytes.size());
  return new Assimp::MemoryIOStream(copy, bytes.size(), true);
}

void AssimpFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace hazumi
