#pragma once

// How FBX says that nodes move, which assimp 5.2.5 passes on only at keys and as quaternions:
//   X = T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1   of a node in its parent
// with the translation T, the rotation R of three angles in the node's order, the scale S, offsets
// and pivots; T, R and S by curves of each axis [FBX SDK, "Computing transformation matrices"]. And
// how geometry lies in its node, which assimp drops where a skin hangs on it:
//   G = GT GR GS.

#include <string>

#include "engine/exchange/fbx/fbx_records.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Replaces the motions of a scene that assimp read from these records by those of the curves, and
// corrects binds of skins on nodes whose geometry is moved. What cannot be told apart stays as
// assimp has it: nodes of one name, clips of several layers. Warns of these.
void TakeFbxMotions(const FbxRecord& records, Scene* scene);

}  // namespace hazumi
