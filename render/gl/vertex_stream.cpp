#include "render/gl/vertex_stream.h"

#include <numeric>

namespace hazumi::render {

VertexStream::VertexStream(const GlFunctions& gl, std::initializer_list<int> sizes)
    : gl_(&gl), array_(gl), vertices_(gl), indices_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const int stride = std::accumulate(sizes.begin(), sizes.end(), 0) * int(sizeof(float));
  std::uintptr_t offset = 0;
  GLuint attribute = 0;
  for (const int size : sizes) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(attribute, size, GL_FLOAT, GL_FALSE, stride,
                           reinterpret_cast<const void*>(offset));
    offset += size * sizeof(float);
    ++attribute;
  }
}

void VertexStream::UploadBytes(const void* data, size_t size) {
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(size), data, GL_STREAM_DRAW);
}

void VertexStream::UploadIndices(const std::vector<std::uint32_t>& indices) {
  gl_->BindVertexArray(array_.id());
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                  GL_STREAM_DRAW);
  index_count_ = static_cast<GLsizei>(indices.size());
}

void VertexStream::DrawTriangles() const {
  gl_->BindVertexArray(array_.id());
  gl_->DrawArrays(GL_TRIANGLES, 0, vertex_count_);
}

void VertexStream::DrawIndexedTriangles() const {
  gl_->BindVertexArray(array_.id());
  gl_->DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace hazumi::render
