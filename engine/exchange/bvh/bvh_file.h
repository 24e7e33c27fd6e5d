#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// The character of a BVH file with its one clip, both named as the file. `file` is its path, for
// messages. Lengths and axes are those of the file, angles are radians; see README.md for what is
// accepted and how it is read. What was repaired is in `warnings`, each with its line. Of `choice`
// only the limit of keys counts, at its rate.
Result<Character> ReadBvh(std::string_view text, const std::string& file,
                          const ReadChoice& choice = {});

// A skeleton and one of its clips as a BVH file, in the axes and the unit of the character. `clip`
// has a track for every bone.
//
// The root has six channels, positions X Y Z and then rotations; others have three, and six if
// they are moved in their parent. Rotations are in the order of the bone, or Z X Y where that is
// unknown: `angles` as they are, where they are given, else angles that go on from frame to frame
// without a jump. Numbers have six decimals, angles are degrees. A bone without a child has an End
// Site, at the bone itself if `end_site` is not given. Several roots are put under one that does
// not move. What BVH cannot say is not written: scales, meshes; and a rest rotation goes into
// every frame.
std::string BvhText(const Character& character, const Clip& clip);

}  // namespace hazumi
