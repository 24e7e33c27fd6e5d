#include "render/gl/skin_buffers.h"

#include <algorithm>
#include <cstddef>

#include "render/image/halve.h"

namespace hazumi::render {
namespace {

std::vector<Eigen::Vector2f> TexturePlacesOf(const SkinModel& model) {
  std::vector<Eigen::Vector2f> places;
  places.reserve(model.num_vertices);
  for (const SkinMesh& mesh : model.skin->meshes) {
    places.insert(places.end(), mesh.texture_coordinates.begin(), mesh.texture_coordinates.end());
    if (mesh.texture_coordinates.empty()) {
      places.resize(places.size() + mesh.positions.size(), Eigen::Vector2f::Zero());
    }
  }
  return places;
}

// White where a mesh has none; empty if none has.
std::vector<Eigen::Vector3f> ColorsOf(const SkinModel& model) {
  const std::vector<SkinMesh>& meshes = model.skin->meshes;
  const auto is_plain = [](const SkinMesh& mesh) { return mesh.colors.empty(); };
  std::vector<Eigen::Vector3f> colors;
  if (std::all_of(meshes.begin(), meshes.end(), is_plain)) return colors;
  colors.reserve(model.num_vertices);
  for (const SkinMesh& mesh : meshes) {
    colors.insert(colors.end(), mesh.colors.begin(), mesh.colors.end());
    if (is_plain(mesh)) {
      colors.resize(colors.size() + mesh.positions.size(), Eigen::Vector3f::Ones());
    }
  }
  return colors;
}

template <typename T>
GlBuffer Filled(const GlFunctions& gl, const std::vector<T>& data) {
  GlBuffer buffer(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                GL_STATIC_DRAW);
  return buffer;
}

// As large as the driver takes.
Image Fitting(const GlFunctions& gl, Image image) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  while (std::max(image.width, image.height) > std::max(most, 1)) image = Halved(image);
  return image;
}

// Repeats in both directions. Read as linear colour; the fourth component as it is.
GlTexture TextureOf(const GlFunctions& gl, const Image& whole) {
  GlTexture texture(gl);
  if (whole.width == 0) return texture;
  const Image image = Fitting(gl, whole);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA,
                GL_UNSIGNED_BYTE, image.rgba.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

Image White() {
  Image image(1, 1);
  image.rgba.assign(4, 255);
  return image;
}

}  // namespace

SkinBuffers::SkinBuffers(const GlFunctions& gl, const std::shared_ptr<const SkinModel>& model)
    : gl_(&gl),
      model_(model),
      texture_places_(Filled(gl, TexturePlacesOf(*model))),
      indices_(Filled(gl, model->indices)) {
  if (const std::vector<Eigen::Vector3f> colors = ColorsOf(*model); !colors.empty()) {
    colors_.emplace(Filled(gl, colors));
  }
  for (const Image& image : model->textures) textures_.push_back(TextureOf(gl, image));
  textures_.push_back(TextureOf(gl, White()));
}

SkinBuffers::PosedBuffers SkinBuffers::MakePose() const {
  PosedBuffers pose{GlVertexArray(*gl_), GlBuffer(*gl_)};
  const auto attribute = [&](GLuint number, GLint size, GLenum type, GLboolean to_unit,
                             GLsizei stride, std::uintptr_t offset) {
    gl_->EnableVertexAttribArray(number);
    gl_->VertexAttribPointer(number, size, type, to_unit, stride,
                             reinterpret_cast<const void*>(offset));
  };
  constexpr GLsizei kStride = sizeof(SkinnedVertex);
  gl_->BindVertexArray(pose.array.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  gl_->BindBuffer(GL_ARRAY_BUFFER, pose.vertices.id());
  attribute(0, 3, GL_FLOAT, GL_FALSE, kStride, offsetof(SkinnedVertex, position));
  attribute(1, 3, GL_FLOAT, GL_FALSE, kStride, offsetof(SkinnedVertex, normal));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offsetof(SkinnedVertex, tint));
  gl_->BindBuffer(GL_ARRAY_BUFFER, texture_places_.id());
  attribute(3, 2, GL_FLOAT, GL_FALSE, 0, 0);
  if (!colors_) return pose;
  gl_->BindBuffer(GL_ARRAY_BUFFER, colors_->id());
  attribute(4, 3, GL_FLOAT, GL_FALSE, 0, 0);
  return pose;
}

size_t SkinBuffers::AddPose(const std::vector<SkinnedVertex>& vertices) {
  if (num_posed_ == poses_.size()) poses_.push_back(MakePose());
  gl_->BindBuffer(GL_ARRAY_BUFFER, poses_[num_posed_].vertices.id());
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(SkinnedVertex)),
                  vertices.data(), GL_STREAM_DRAW);
  return num_posed_++;
}

void SkinBuffers::BindTexture(int texture) const {
  const GlTexture& wanted =
      texture < 0 ? textures_.back() : textures_[static_cast<size_t>(texture)];
  gl_->BindTexture(GL_TEXTURE_2D, wanted.id());
}

void SkinBuffers::DrawLevel(const SkinModel::Level& level) const {
  const std::uintptr_t offset = level.first_index * sizeof(std::uint32_t);
  gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(level.num_indices), GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(offset));
}

}  // namespace hazumi::render
