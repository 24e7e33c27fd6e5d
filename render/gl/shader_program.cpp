#include "render/gl/shader_program.h"

#include <cstdio>
#include <utility>

#include "engine/base/assert.h"

namespace hazumi::render {
namespace {

GLuint Compile(const GlFunctions& gl, GLenum kind, const std::string& source) {
  const std::string text = "#version 330 core\n" + source;
  const char* pointer = text.c_str();
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &pointer, nullptr);
  gl.CompileShader(shader);
  return shader;
}

void DemandLinked(const GlFunctions& gl, GLuint program) {
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  char log[2048] = "";
  gl.GetProgramInfoLog(program, sizeof(log), nullptr, log);
  std::fprintf(stderr, "%s\n", log);
  HAZUMI_DEMAND(linked == GL_TRUE);
}

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::string& defines,
                             const std::string& vertex, const std::string& fragment)
    : gl_(&gl), id_(gl.CreateProgram()) {
  const GLuint shaders[] = {Compile(gl, GL_VERTEX_SHADER, defines + vertex),
                            Compile(gl, GL_FRAGMENT_SHADER, defines + fragment)};
  for (const GLuint shader : shaders) gl.AttachShader(id_, shader);
  gl.BindAttribLocation(id_, 0, "a_0");
  gl.BindAttribLocation(id_, 1, "a_1");
  gl.BindAttribLocation(id_, 2, "a_2");
  gl.BindAttribLocation(id_, 3, "a_3");
  gl.BindAttribLocation(id_, 4, "a_4");
  gl.LinkProgram(id_);
  DemandLinked(gl, id_);
  for (const GLuint shader : shaders) gl.DeleteShader(shader);
}

ShaderProgram::~ShaderProgram() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept { *this = std::move(other); }

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  return *this;
}

void ShaderProgram::Use() const { gl_->UseProgram(id_); }

GLint ShaderProgram::Find(const char* name) const { return gl_->GetUniformLocation(id_, name); }

void ShaderProgram::Set(const char* name, int value) const { gl_->Uniform1i(Find(name), value); }

void ShaderProgram::Set(const char* name, float value) const { gl_->Uniform1f(Find(name), value); }

void ShaderProgram::Set(const char* name, const Eigen::Vector4d& value) const {
  const Eigen::Vector4f v = value.cast<float>();
  gl_->Uniform4f(Find(name), v.x(), v.y(), v.z(), v.w());
}

void ShaderProgram::Set(const char* name, const SrgbColor& c) const {
  gl_->Uniform4f(Find(name), c.r, c.g, c.b, c.a);
}

void ShaderProgram::Set(const char* name, const LinearColor& c) const {
  gl_->Uniform4f(Find(name), c.r, c.g, c.b, c.a);
}

void ShaderProgram::Set(const char* name, const Mat4& matrix) const {
  const Eigen::Matrix4f m = matrix.cast<float>();
  gl_->UniformMatrix4fv(Find(name), 1, GL_FALSE, m.data());
}

}  // namespace hazumi::render
