#pragma once

#include <string>

#include "render/gl/gl_functions.h"
#include "render/scene/camera.h"
#include "render/scene/color.h"

namespace hazumi::render {

// A linked program. Vertex attributes 0, 1, 2, 3 are a_0, a_1, a_2, a_3. A source that does not
// compile is our bug: it stops the program with the driver's message.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  // `defines` goes in front of both sources, after the version line.
  ShaderProgram(const GlFunctions& gl, const std::string& defines, const std::string& vertex,
                const std::string& fragment);
  ~ShaderProgram();
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;

  void Use() const;

  // Of the program in use.
  void Set(const char* name, int value) const;
  void Set(const char* name, float value) const;
  void Set(const char* name, const Eigen::Vector4d& value) const;
  void Set(const char* name, const SrgbColor& color) const;
  void Set(const char* name, const LinearColor& color) const;
  void Set(const char* name, const Mat4& matrix) const;

 private:
  GLint Find(const char* name) const;

  const GlFunctions* gl_ = nullptr;
  GLuint id_ = 0;
};

}  // namespace hazumi::render
