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
  const auto wrong = [](const std::string& place, const std::string& what) {
    return "skin." + place + ": does not fit together: " + what;
  };
  return {
      {Check::kNotBytes, ReadSkin("/skin/meshes/0/positions", "\"AA*A\""),
       "skin.meshes[0].positions: must be base64 of whole entries"},
      {Check::kNotBytes, ReadSkin("/skin/meshes/0/weights", "\"AAAA\""),
       "skin.meshes[0].weights: must be base64 of whole entries"},
      {Check::kMissingField, ReadSkin("/skin/meshes/0/triangles", ""),
       "skin.meshes[0]: the field \"triangles\" is missing; add it"},
      {Check::kWrongCount, ReadSkin("/skin/meshes/0/binds/1/inverse_bind", "[1, 2]"),
       "skin.meshes[0].binds[1].inverse_bind: expected 12 values, found 2"},
      {Check::kUnknownChoice, ReadSkin("/skin", R"({"shipped": "humna"})"),
       "skin.shipped: there is no skin \"humna\"; did you mean \"human\"?"},
      {Check::kBadMesh, ReadSkin("/skin/bones/0", R"({"joint": "r_knee", "share": 1.5})"),
       wrong("bones[0].share", "must be a number from 0 to 1")},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/normals", "\"\""),
       wrong("meshes[0].normals", "has 0 entries for 3 vertices; import the mesh anew")},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/binds/0/bone", "2"),
       wrong("meshes[0].binds[0].bone", "there is no such bone")},
      {Check::kBadMesh,
       ReadSkin("/skin/meshes/0/bind_indices", "\"AgAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\""),
       wrong("meshes[0].bind_indices[0]", "there is no bind 2; the mesh has 2")},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/triangles", "\"AAAAAAEAAAADAAAA\""),
       wrong("meshes[0].triangles[0]", "there is no vertex 3")},
      {Check::kBadMesh, ReadSkin("/skin/meshes/0/material", "1"),
       wrong("meshes[0].material", "there is no such material")},
      {Check::kBadMesh, ReadSkin("/skin/materials/0/texture", "1"),
       wrong("materials[0].texture", "there is no such texture")},
  };
}

}  // namespace hazumi::testing
