#pragma once

// Internal. Files, scene and axes as assimp has them, for ReadByAssimp.

#include <assimp/scene.h>

#include <assimp/IOSystem.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/exchange/content.h"
#include "engine/exchange/scene/scene.h"
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

Eigen::Matrix4d ToMatrix(const aiMatrix4x4& matrix);

// Adds what assimp has read to a scene. `ticks_are_frames`: a tick is a frame of the rate that the
// file states (FBX). Error: meshes whose indices are out of range, nodes without end.
Result<Done> AddAssimpScene(const aiScene& from, bool ticks_are_frames, const std::string& file,
                            Scene* scene);

// Sets the scene's up axis and unit from what the format or the file says, and takes off the
// scene's root what assimp put there for them, so that lengths and axes are the file's own.
void TakeAxesAndUnit(CharacterFormat format, aiScene* from, Scene* scene);

}  // namespace hazumi
