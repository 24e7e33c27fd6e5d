#pragma once

#include <optional>
#include <string>

#include "engine/timeline/scene_object.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// "#rrggbb"; anything else is a mid grey.
SrgbColor ColorFromText(const std::string& text);

// Adds an object of the world. A level plane becomes the scene's ground, another one a large slab.
void AddSceneObject(const SceneObject& object, Scene* scene);

// Adds a held object at its pose in the world.
void AddHeldObject(const HeldObject& object, const Pose& X_WO, float alpha, Scene* scene);

// Height of the object's level top where `point` is above it; none if it is not.
std::optional<double> TopBelow(const SceneObject& object, const Vec3& point);

}  // namespace hazumi::render
