#pragma once

// Internal. Changed bones in a glTF, GLB or VRM file.

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/onto/edited_bones.h"

namespace hazumi {

// The file with new samplers, linear from frame to frame, for the changed bones of the clip; a file
// without clips gets one. Everything else keeps its numbers, its place and its bytes in buffers. Of
// a .glb new numbers are in its own buffer, else in one more, inside the file.
// Errors: kSyntax, kSchema: it is no glTF, or not the one that the bones are of; kSemantics: a
// frame before the file's time 0, numbers that no float holds.
Result<std::string> GltfOnto(std::string_view bytes, const EditedClip& clip);

// Whether a glTF file names files beside it, such as pictures.
Result<bool> HasFilesBeside(std::string_view bytes);

}  // namespace hazumi
