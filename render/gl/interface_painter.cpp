#include "render/gl/interface_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "render/gl/draw_targets.h"
#include "render/gl/interface_changes.h"
#include "render/gl/shader_program.h"
#include "render/gl/shaders.h"

namespace hazumi::render {

namespace {

// How triangles are filled. Most of an interface is large rectangles of one colour, and the picture
// of the scene: without texture or without blending they take a fraction of the time.
enum class Fill { kBlended, kSolid, kPicture };

// The corners of a rectangle, as six indices, if it hides what is behind it.
std::optional<Fill> LargeRectangle(const InterfaceLayer& layer, const InterfacePart& part,
                                   unsigned first, bool is_picture) {
  constexpr float kLarge = 2048.0f;  // [px^2]
  const std::uint16_t* i = &layer.indices[part.first_index + first];
  if (i[3] != i[0] || i[4] != i[2]) return std::nullopt;
  const auto at = [&](int k) -> const InterfaceVertex& {
    return layer.vertices[part.first_vertex + i[k]];
  };
  const InterfaceVertex &a = at(0), &b = at(1), &c = at(2), &d = at(5);
  const bool is_upright = a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x;
  if (!is_upright || std::abs((c.x - a.x) * (c.y - a.y)) < kLarge) return std::nullopt;
  const auto is_opaque = [](const InterfaceVertex& v) { return v.rgba >> 24 == 255; };
  if (!is_opaque(a) || !is_opaque(b) || !is_opaque(c) || !is_opaque(d)) return std::nullopt;
  if (is_picture) return Fill::kPicture;
  const auto is_same_place = [&](const InterfaceVertex& v) { return v.u == a.u && v.v == a.v; };
  return is_same_place(b) && is_same_place(c) && is_same_place(d) ? std::optional(Fill::kSolid)
                                                                  : std::nullopt;
}

}  // namespace

struct InterfacePainter::State {
  explicit State(const GlFunctions& functions)
      : gl(functions),
        program(gl, "", shaders::kInterfaceVertex, shaders::kInterfaceFragment),
        solid(gl, "", shaders::kInterfaceVertex, shaders::kInterfaceSolidFragment),
        array(gl),
        vertices(gl),
        indices(gl),
        kept(gl) {
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

  void Begin(PictureSize size, const SrgbColor& clear);
  void SeeThrough(const PixelRect& rect) const {
    gl.Scissor(rect.left, kept.size().height - rect.bottom, rect.right - rect.left,
               rect.bottom - rect.top);
  }
  void DrawLayer(const InterfaceLayer& layer, const PixelRect& within) const;
  void DrawPart(const InterfaceLayer& layer, const InterfacePart& part) const;
  void DrawTriangles(const InterfacePart& part, unsigned first, unsigned end, Fill fill) const;
  void End() const;

  GlFunctions gl;
  ShaderProgram program, solid;
  GlVertexArray array;
  GlBuffer vertices, indices;
  DrawnTexture kept;  // what was drawn last, as buffers of a window are not kept
  SrgbColor background;
  InterfaceChanges changes;
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
  state_->changes.Forget();
  return id;
}

void InterfacePainter::FreeTexture(unsigned texture) {
  state_->textures.erase(texture);
  state_->changes.Forget();
}

void InterfacePainter::State::Begin(PictureSize size, const SrgbColor& clear) {
  (void)kept.Begin(gl, size);
  gl.Viewport(0, 0, size.width, size.height);
  gl.ClearColor(clear.r, clear.g, clear.b, 1.0f);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  for (const ShaderProgram* each : {&solid, &program}) {
    each->Use();
    each->Set("size", Eigen::Vector4d(size.width, size.height, 0.0, 0.0));
  }
  program.Set("picture", 0);
  gl.BindVertexArray(array.id());
}

void InterfacePainter::State::DrawLayer(const InterfaceLayer& layer,
                                        const PixelRect& within) const {
  const auto seen_of = [&](const InterfacePart& part) {
    return Common(within, PixelsOf(part.left, part.top, part.right, part.bottom));
  };
  const auto is_seen = [&](const InterfacePart& part) { return !seen_of(part).is_empty(); };
  if (std::none_of(layer.parts.begin(), layer.parts.end(), is_seen)) return;
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(layer.vertices.size_bytes()),
                layer.vertices.data(), GL_STREAM_DRAW);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(layer.indices.size_bytes()),
                layer.indices.data(), GL_STREAM_DRAW);
  for (const InterfacePart& part : layer.parts) {
    const PixelRect seen = seen_of(part);
    if (seen.is_empty()) continue;
    SeeThrough(seen);
    gl.BindTexture(GL_TEXTURE_2D, part.texture);
    DrawPart(layer, part);
  }
}

void InterfacePainter::State::DrawPart(const InterfaceLayer& layer,
                                       const InterfacePart& part) const {
  const bool is_picture = !textures.contains(part.texture);
  unsigned drawn = 0;
  for (unsigned i = 0; i + 6 <= part.num_indices;) {
    const std::optional<Fill> fill = LargeRectangle(layer, part, i, is_picture);
    if (!fill) {
      i += 3;
      continue;
    }
    DrawTriangles(part, drawn, i, Fill::kBlended);
    DrawTriangles(part, i, i + 6, *fill);
    drawn = i += 6;
  }
  DrawTriangles(part, drawn, part.num_indices, Fill::kBlended);
}

void InterfacePainter::State::DrawTriangles(const InterfacePart& part, unsigned first, unsigned end,
                                            Fill fill) const {
  if (first == end) return;
  if (fill == Fill::kSolid) solid.Use();
  if (fill != Fill::kBlended) gl.Disable(GL_BLEND);
  const std::uintptr_t offset = (part.first_index + first) * sizeof(std::uint16_t);
  gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(end - first), GL_UNSIGNED_SHORT,
                            reinterpret_cast<const void*>(offset),
                            static_cast<GLint>(part.first_vertex));
  if (fill != Fill::kBlended) gl.Enable(GL_BLEND);
  if (fill == Fill::kSolid) program.Use();
}

// Brings it into the context's own framebuffer, and leaves the state as the passes of a frame
// expect it.
void InterfacePainter::State::End() const {
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_CULL_FACE);
  const PictureSize size = kept.size();
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, kept.framebuffer());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height,
                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void InterfacePainter::Draw(const std::vector<InterfaceLayer>& layers, PictureSize size,
                            const SrgbColor& clear, bool has_new_picture) {
  State& state = *state_;
  if (!(clear == state.background)) state.changes.Forget();
  state.background = clear;
  state.Begin(size, clear);
  const auto is_own = [&](unsigned texture) { return state.textures.contains(texture); };
  for (const PixelRect& rect : state.changes.Since(layers, size, has_new_picture, is_own)) {
    state.SeeThrough(rect);
    state.gl.Clear(GL_COLOR_BUFFER_BIT);
    for (const InterfaceLayer& layer : layers) state.DrawLayer(layer, rect);
  }
  state.End();
}

void InterfacePainter::Finish() { state_->gl.Finish(); }

}  // namespace hazumi::render
