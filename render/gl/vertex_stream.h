#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "render/gl/gl_name.h"

namespace hazumi::render {

// Vertices (and indices) that change every frame. Each vertex is a run of floats.
class VertexStream {
 public:
  VertexStream() = default;
  // `sizes`: floats of the attributes 0, 1, ... that make up a vertex.
  VertexStream(const GlFunctions& gl, std::initializer_list<int> sizes);

  template <typename Vertex>
  void Upload(const std::vector<Vertex>& vertices) {
    UploadBytes(vertices.data(), vertices.size() * sizeof(Vertex));
    vertex_count_ = static_cast<GLsizei>(vertices.size());
  }
  void UploadIndices(const std::vector<std::uint32_t>& indices);

  bool has_vertices() const { return vertex_count_ > 0; }
  bool has_indices() const { return index_count_ > 0; }
  void DrawTriangles() const;         // vertices in threes
  void DrawIndexedTriangles() const;  // indices in threes

 private:
  void UploadBytes(const void* data, size_t size);

  const GlFunctions* gl_ = nullptr;
  GlVertexArray array_;
  GlBuffer vertices_, indices_;
  GLsizei vertex_count_ = 0, index_count_ = 0;
};

}  // namespace hazumi::render
