#pragma once

// Internal. Parts of the character that a scene becomes: meshes, materials and clips.

#include "engine/exchange/scene/scene.h"
#include "engine/exchange/scene/scene_folder.h"
#include "engine/exchange/scene/scene_skeleton.h"

namespace hazumi {

// All meshes: skinned ones with the four strongest bones of each vertex, others bound to the bone
// that they hang on. Warns of weights cut off and of vertices without any.
std::vector<SkinMesh> ReadMeshes(const SceneTree& tree, const SceneSkeleton& skeleton,
                                 std::vector<Warning>* warnings);

// Materials that the character's meshes have, and their pictures: embedded, or in the scene's
// folder. Warns of pictures that are missing, lie elsewhere, or are neither PNG nor JPEG.
void ReadMaterials(const Scene& scene, SceneFolder* folder, Character* character);

// The frame rate on whose frames all the times [s], sorted, lie: `likely` first if it is positive,
// then 30, 24, 25, 60 and other usual ones. 0: none.
double FrameRateOf(const std::vector<double>& times, double likely);

// All clips that move a bone, sampled from the first key (frame 0) to the last, `rate` times a
// second (0: on the frames of the keys). Error: key times or values that are none, or too many
// frames.
Result<std::vector<Clip>> ReadClips(const SceneTree& tree, const SceneSkeleton& skeleton,
                                    double rate, const std::string& file,
                                    std::vector<Warning>* warnings);

}  // namespace hazumi
