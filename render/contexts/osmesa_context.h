#pragma once

#include <cstdint>
#include <memory>

#include "engine/base/result.h"
#include "render/gl/gl_functions.h"

namespace hazumi::render {

// An OpenGL context without a screen: Mesa's llvmpipe drawing into memory. The library is loaded
// when first needed and never linked, since it and libGL export the same names.
class OsmesaContext {
 public:
  // Fails (kFailed) when libOSMesa.so.8 is missing, naming the package to install.
  static Result<OsmesaContext> Create();
  ~OsmesaContext();
  OsmesaContext(OsmesaContext&& other) noexcept;
  OsmesaContext& operator=(OsmesaContext&& other) noexcept;

  // Makes the context current on this thread, with framebuffer 0 kept in `rgba`: width * height * 4
  // bytes, top row first, complete after glFinish. The buffer must live until the next call.
  // May be called every frame with another buffer of the same size. False if Mesa refuses.
  bool MakeCurrent(std::uint8_t* rgba, int width, int height);

  // For Renderer::Create.
  GlProcLoader loader() const;

 private:
  struct Library;
  OsmesaContext(const Library* library, void* context);

  const Library* library_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace hazumi::render
