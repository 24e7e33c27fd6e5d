#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "engine/dynamics/kinematics.h"
#include "render/mesh/solid_mesh.h"
#include "render/motion/figure_skin.h"
#include "render/motion/motion_scene.h"
#include "render/motion/object_scene.h"

namespace hazumi::render {

namespace {

// The mesh of one colour.
struct ColorMesh {
  using Corner = std::array<long, 6>;  // place and normal, rounded

  SkinMesh mesh;
  std::map<int, uint16_t> bind_of_bone;
  std::map<std::pair<int, Corner>, uint32_t> vertices;  // welded, by bone
};

class SkinMaker {
 public:
  SkinMaker(const Figure& figure, int columns) : figure_(figure), columns_(columns), ws_(figure) {
    ComputePositions(figure_, Pose(), VecX::Zero(figure_.num_joints()), &ws_);
    skin_.bones.push_back(figure_.root_name());
    for (const JointGroup& group : figure_.groups()) skin_.bones.push_back(group.name);
  }

  Skin Make() {
    for (const Link& link : figure_.links()) {
      for (const Look& look : LooksOf(link)) AddLook(link.joint, look);
    }
    for (ColorMesh& color : colors_) skin_.meshes.push_back(std::move(color.mesh));
    return std::move(skin_);
  }

 private:
  Pose PoseOf(JointIndex body) const { return {ws_.body(body).R, ws_.body(body).p}; }

  void AddLook(JointIndex body, const Look& look) {
    const Pose X_RB = PoseOf(body);
    SolidMesh solid;
    if (look.shape == Look::Shape::kTaperedCapsule) {
      AppendTaperedCapsule(
          {X_RB * look.from, X_RB * look.to, look.radius_from, look.radius_to, SrgbColor()},
          columns_, solid);
    } else {
      AppendEllipsoid({{X_RB.R, X_RB * look.center}, look.half_axes, SrgbColor()}, columns_, solid);
    }
    AddSolid(body, solid, &MeshOf(look.color));
  }

  ColorMesh& MeshOf(const std::string& color) {
    const auto [entry, is_new] = color_numbers_.try_emplace(color, colors_.size());
    if (is_new) {
      const LinearColor c = ToLinear(ColorFromText(color));
      skin_.materials.push_back({color, {c.r, c.g, c.b, c.a}, -1});
      ColorMesh made;
      made.mesh.name = figure_.name() + " " + color;
      made.mesh.material = static_cast<int>(colors_.size());
      colors_.push_back(std::move(made));
    }
    return colors_[entry->second];
  }

  void AddSolid(JointIndex body, const SolidMesh& solid, ColorMesh* color) {
    const int bone = body.is_valid() ? 1 + figure_.joint(body).group.value() : 0;
    const uint16_t bind = BindOf(bone, body, color);
    std::vector<uint32_t> numbers;
    for (const SolidVertex& vertex : solid.vertices) {
      numbers.push_back(VertexOf(bone, bind, vertex, color));
    }
    for (size_t i = 0; i + 2 < solid.indices.size(); i += 3) {
      const std::array<uint32_t, 3> t = {numbers[solid.indices[i]], numbers[solid.indices[i + 1]],
                                         numbers[solid.indices[i + 2]]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) color->mesh.triangles.push_back(t);
    }
  }

  uint16_t BindOf(int bone, JointIndex body, ColorMesh* color) {
    const auto [entry, is_new] =
        color->bind_of_bone.try_emplace(bone, static_cast<uint16_t>(color->mesh.binds.size()));
    if (is_new) {
      const Pose X_BR = PoseOf(body).Inverse();
      SkinMesh::Bind bind;
      bind.bone = bone;
      bind.inverse_bind.topLeftCorner<3, 3>() = X_BR.R;
      bind.inverse_bind.topRightCorner<3, 1>() = X_BR.p;
      color->mesh.binds.push_back(bind);
    }
    return entry->second;
  }

  static uint32_t VertexOf(int bone, uint16_t bind, const SolidVertex& v, ColorMesh* color) {
    SkinMesh& mesh = color->mesh;
    constexpr float kFineness = 1e5f;  // 0.01 mm
    ColorMesh::Corner corner;
    for (size_t i = 0; i < 3; ++i) {
      corner[i] = std::lround(kFineness * v.position[i]);
      corner[3 + i] = std::lround(kFineness * v.normal[i]);
    }
    const auto [entry, is_new] =
        color->vertices.try_emplace({bone, corner}, static_cast<uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.emplace_back(v.position[0], v.position[1], v.position[2]);
      mesh.normals.emplace_back(v.normal[0], v.normal[1], v.normal[2]);
      mesh.bind_indices.push_back({bind, 0, 0, 0});
      mesh.weights.push_back({1.0f, 0.0f, 0.0f, 0.0f});
    }
    return entry->second;
  }

  const Figure& figure_;
  int columns_;
  DynamicsWorkspace ws_;
  Skin skin_;
  std::vector<ColorMesh> colors_;  // by material
  std::map<std::string, size_t> color_numbers_;
};

}  // namespace

Skin SkinOfLinks(const Figure& figure, int columns) { return SkinMaker(figure, columns).Make(); }

}  // namespace hazumi::render
