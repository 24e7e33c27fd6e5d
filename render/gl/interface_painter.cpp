#include "render/gl/interface_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "render/gl/gl_name.h"
#include "render/gl/shader_program.h"
#include "render/gl/shaders.h"

namespace hazumi::render {

struct InterfacePainter::State {
  explicit State(const GlFunctions& functions)
      : gl(functions),
        program(gl, "", shaders::kInterfaceVertex, shaders::kInterfaceFragment),
        array(gl),
        vertices(gl),
        indices(gl) {
    gl.BindVertexArray(array.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    AddAttribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(InterfaceVertex, x));
    AddAttribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(InterfaceVertex, u));
    AddAttribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(InterfaceVertex, rgba));
  }

  void AddAttribute(GLuint index, int size, GLenum type, GLboolean normalized,
                    std::uintptr_t offset) const {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, size, type, normalized, sizeof(InterfaceVertex),
                           reinterpret_cast<const void*>(offset));
  }

  void Begin(PictureSize size, const SrgbColor& clear) const;
  void DrawLayer(const InterfaceLayer& layer, PictureSize size) const;
  void End() const;

  GlFunctions gl;
  ShaderProgram program;
  GlVertexArray array;
  GlBuffer vertices, indices;
  std::map<unsigned, GlTexture> textures;  // by id
};

InterfacePainter::InterfacePainter(std::unique_ptr<State> state) : state_(std::move(state)) {}
InterfacePainter::~InterfacePainter() = default;
InterfacePainter::InterfacePainter(InterfacePainter&&) noexcept = default;
InterfacePainter& InterfacePainter::operator=(InterfacePainter&&) noexcept = default;

Result<InterfacePainter> InterfacePainter::Create(GlProcLoader loader) {
  const Result<GlFunctions> gl = LoadGlFunctions(loader);
  if (!gl.ok()) return gl.error();
  return InterfacePainter(std::make_unique<State>(gl.value()));
}

unsigned InterfacePainter::AddTexture(const std::uint8_t* rgba, PictureSize size) {
  const GlFunctions& gl = state_->gl;
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                rgba);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  }
  const unsigned id = texture.id();
  state_->textures.emplace(id, std::move(texture));
  return id;
}

void InterfacePainter::FreeTexture(unsigned texture) { state_->textures.erase(texture); }

void InterfacePainter::State::Begin(PictureSize size, const SrgbColor& clear) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.Viewport(0, 0, size.width, size.height);
  gl.ClearColor(clear.r, clear.g, clear.b, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  program.Use();
  program.Set("picture", 0);
  program.Set("size", Eigen::Vector4d(size.width, size.height, 0.0, 0.0));
  gl.BindVertexArray(array.id());
}

void InterfacePainter::State::DrawLayer(const InterfaceLayer& layer, PictureSize size) const {
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(layer.vertices.size_bytes()),
                layer.vertices.data(), GL_STREAM_DRAW);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(layer.indices.size_bytes()),
                layer.indices.data(), GL_STREAM_DRAW);
  for (const InterfacePart& part : layer.parts) {
    const int left = std::max(0, static_cast<int>(std::floor(part.left)));
    const int top = std::max(0, static_cast<int>(std::floor(part.top)));
    const int right = std::min(size.width, static_cast<int>(std::ceil(part.right)));
    const int bottom = std::min(size.height, static_cast<int>(std::ceil(part.bottom)));
    if (right <= left || bottom <= top) continue;
    gl.Scissor(left, size.height - bottom, right - left, bottom - top);
    gl.BindTexture(GL_TEXTURE_2D, part.texture);
    const std::uintptr_t offset = part.first_index * sizeof(std::uint16_t);
    gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(part.num_indices),
                              GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(offset),
                              static_cast<GLint>(part.first_vertex));
  }
}

// Leaves the state as the passes of a frame expect it.
void InterfacePainter::State::End() const {
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_CULL_FACE);
}

void InterfacePainter::Draw(const std::vector<InterfaceLayer>& layers, PictureSize size,
                            const SrgbColor& clear) {
  state_->Begin(size, clear);
  for (const InterfaceLayer& layer : layers) state_->DrawLayer(layer, size);
  state_->End();
}

void InterfacePainter::Finish() { state_->gl.Finish(); }

}  // namespace hazumi::render
