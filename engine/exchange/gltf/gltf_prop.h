#pragma once

#include "engine/exchange/character/character.h"

namespace hazumi {

// A thing beside the skeleton, in the axes and lengths of the file.
struct GltfProp {
  SkinMesh mesh;    // without binds, about the thing's own origin
  int bone = -1;    // that carries it; -1: none, it moves by itself
  Pose rest;        // in the frame of its bone, or in the world
  BoneTrack track;  // as the character's first clip moves it there; empty: it stays
};

}  // namespace hazumi
