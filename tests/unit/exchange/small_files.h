#pragma once

// Files of other programs, small enough to know every number in them.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi::test {

// Z up, unit 1 m. "Hips" at (0, 0, 1) with a pre-rotation of 90 degrees about z, turning about its
// x from 10 to 70 degrees in 30 frames at 30 a second; its end 0.5 along its x. `extra`: more
// properties of Hips.
std::string SmallFbx(const std::string& extra = "");
// Z up, unit 1 cm. "Hips" at z 100, turning about z from 0 to 90 degrees in a second; its end 50
// above it.
std::string SmallCollada();
// Two bones along y, "lower" at the origin and "upper" at y = 1, which turns about z from 0 to 90
// degrees in half a second; a strip of four vertices at y = 0, 0, 2, 2, the first two on "lower"
// and the others on "upper". Everything in the JSON.
nlohmann::json SmallGltf();
// The same with these key times [s], the angles going evenly from 0 to 90 degrees.
nlohmann::json SmallGltfWithTimes(const std::vector<float>& times);
// The same with weights of `bytes` (1 or 2) bytes: 1, 1, 0.2, 0.2 on "lower", the rest on "upper".
nlohmann::json SmallGltfWithIntegerWeights(size_t bytes);
// A scene without a skin: nodes with names, parents before them (-1: the scene's own), places. What
// moves goes 1 along x and back in a second.
struct BareNode {
  std::string name;
  int parent = -1;
  std::array<double, 3> at = {0, 0, 0};
  bool moves = false, has_mesh = false, is_camera = false;
};
nlohmann::json BareGltf(const std::vector<BareNode>& nodes);

// Writes it to a folder of its own and reads it; a failure fails the test.
Character ReadSmall(const std::string& name, const std::string& contents);
Error ErrorOfSmall(const std::string& name, const std::string& contents);

// How far "upper" of SmallGltf is turned about z at a frame of the first clip [deg].
double UpperTurnAt(const Character& character, size_t frame);
// A bone's frame at rest in the scene's.
Pose WorldRest(const Character& character, size_t bone);

}  // namespace hazumi::test
