#pragma once

#include "engine/exchange/character/character.h"

namespace hazumi {

// The meshes of a thing in the world's axes [m], about the middle of the box around them.
struct ThingMesh {
  Skin skin;
  Vec3 size = Vec3::Zero();  // of that box
};

// Of what ReadThing reads. A unit that the file does not say is a metre; of something longer than
// kLongestThing it is a centimetre or a millimetre.
constexpr double kLongestThing = 3.0;  // [m]
ThingMesh MeshOfThing(const Character& character);

}  // namespace hazumi
