#pragma once

#include <utility>

#include "render/gl/gl_functions.h"

namespace hazumi::render {

// Owns one GL object made by a glGen* function. Made and destroyed with the context current; the
// function table must outlive it.
template <auto kGenerate, auto kDelete>
class GlName {
 public:
  GlName() = default;
  explicit GlName(const GlFunctions& gl) : gl_(&gl) { (gl.*kGenerate)(1, &id_); }
  ~GlName() { Reset(); }
  GlName(GlName&& other) noexcept { *this = std::move(other); }
  GlName& operator=(GlName&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }

  GLuint id() const { return id_; }

 private:
  void Reset() {
    if (id_ != 0) (gl_->*kDelete)(1, &id_);
    id_ = 0;
  }

  const GlFunctions* gl_ = nullptr;
  GLuint id_ = 0;
};

using GlBuffer = GlName<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlVertexArray = GlName<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlTexture = GlName<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlFramebuffer = GlName<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;
using GlRenderbuffer = GlName<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;

}  // namespace hazumi::render
