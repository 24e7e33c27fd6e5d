#pragma once

#include <assimp/scene.h>

#include "engine/base/result.h"
#include "engine/exchange/content.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

Eigen::Matrix4d ToMatrix(const aiMatrix4x4& matrix);

// Adds what assimp has read to a scene. `ticks_are_frames`: a tick is a frame of the rate that the
// file states (FBX). Error: meshes whose indices are out of range, nodes without end.
Result<Done> AddAssimpScene(const aiScene& from, bool ticks_are_frames, const std::string& file,
                            Scene* scene);

// Sets the scene's up axis and unit from what the format or the file says, and takes off the
// scene's root what assimp put there for them, so that lengths and axes are the file's own.
void TakeAxesAndUnit(CharacterFormat format, aiScene* from, Scene* scene);

}  // namespace hazumi
