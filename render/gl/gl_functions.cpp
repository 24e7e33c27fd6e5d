#include "render/gl/gl_functions.h"

namespace hazumi::render {
namespace {

template <typename Function>
void Load(GlProcLoader loader, const char* name, Function& function, const char*& missing) {
  function = reinterpret_cast<Function>(loader(name));
  if (function == nullptr && missing == nullptr) missing = name;
}

}  // namespace

Result<GlFunctions> LoadGlFunctions(GlProcLoader loader) {
  GlFunctions gl;
  const char* missing = nullptr;
#define HAZUMI_GL_LOAD(type, name) Load(loader, "gl" #name, gl.name, missing);
  HAZUMI_GL_FUNCTIONS(HAZUMI_GL_LOAD)
#undef HAZUMI_GL_LOAD
  if (missing == nullptr) return gl;
  return Error{ErrorCode::kFailed, "", "OpenGL",
               std::string("this driver lacks ") + missing + "; OpenGL 3.3 or newer is needed"};
}

}  // namespace hazumi::render
