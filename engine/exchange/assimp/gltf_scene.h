#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/exchange/assimp/gltf_document.h"

namespace hazumi {

// Gives a document without a default scene one, without which assimp gives up: the first scene or,
// if there is none, one of all nodes that are no children; warns of which where there was a choice.
// Error: there are no nodes, or each is a child.
Result<Done> ChooseScene(GltfDocument* document, const std::string& file,
                         std::vector<Warning>* warnings);

}  // namespace hazumi
