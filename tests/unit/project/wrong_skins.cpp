// Skins that do not fit together.

#include "tests/unit/project/skin_sample.h"
#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

Say ReadSkin(std::string pointer, std::string value) {
  return [=] { return Complaint(ParseProject(WithSkin({{pointer, value}}).dump(), "wrong.kfa")); };
}

}  // namespace

std::vector<WrongProject> WrongSkins() {
  const std::string kMesh = "skin.meshes[0]: does not fit together: ";
  return {
      {Check::kNotBytes, ReadSkin("/skin/meshes/0/positions", "\"AA*A\""),
       "skin.meshes[0].positions: must be base64 of whole entries"},
      {Check::kNotBytes, ReadSkin("/skin/meshes/0/weights", "\"AAAA\""),
       "skin.meshes[0].weights: must be base64 of whole entries"},
      {Check::kMissingField, ReadSkin("/skin/meshes/0/triangles", ""),
       "skin.meshes[0]: the field \"triangles\" is missing; add it"},
      {Check::kWrongCount, ReadSkin("/skin/meshes/0/binds/1/inverse_bind", "[1, 2]"),
       "skin.meshes[0].binds[1].inverse_bind: expected 12 values, found 2"},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/normals", "\"\""),
       kMesh + "its vertices have more of one property than of another"},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/binds/0/bone", "2"),
       kMesh + "its binds name no bone of the skin, or are not finite"},
      {Check::kBadMesh,
       ReadSkin("/skin/meshes/0/bind_indices", "\"AgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\""),
       kMesh + "a vertex follows a bind that is not there, or by no weight"},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/triangles", "\"AAAAAAEAAAADAAAA\""),
       kMesh + "a triangle has a corner that is not there"},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/material", "1"),
       kMesh + "its material is not there"},
      {Check::kBadMesh, ReadSkin("/skin/materials/0/texture", "1"),
       "skin.materials[0]: does not fit together: its texture is not there"},
  };
}

}  // namespace hazumi::testing
