#pragma once

#include <assimp/IOSystem.hpp>
#include <string>

#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// assimp opens all files by this: the scene itself, and what its folder has.
class AssimpFiles : public Assimp::IOSystem {
 public:
  // The scene is `bytes`, under the name `main_name()`: its path with the suffix that assimp
  // expects of the format. The folder has to outlive this.
  AssimpFiles(std::string bytes, const std::string& path, const std::string& suffix,
              SceneFolder* folder);

  const std::string& main_name() const { return main_name_; }

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  std::string bytes_, main_name_;
  SceneFolder* folder_;
};

}  // namespace hazumi
