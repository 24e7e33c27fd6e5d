#include "render/contexts/osmesa_context.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

namespace hazumi::render {
namespace {

// From GL/osmesa.h, which pulls in GL/gl.h and its prototypes.
constexpr int kYUp = 0x11;
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;
constexpr int kRgba = GL_RGBA;

constexpr const char* kLibraryName = "libOSMesa.so.8";

template <typename Function>
bool Find(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
  return function != nullptr;
}

Error CannotLoad(const std::string& reason) {
  return {ErrorCode::kFailed, kLibraryName, "",
          "cannot draw without a screen: " + reason + "; install the Debian package libosmesa6"};
}

// With two cores or fewer, one draws and one encodes: llvmpipe's own threads would only get in the
// way (measured: 10 % more work). The picture is the same to the bit. The user's setting wins.
void ChooseMesaThreads() {
  constexpr int kKeepUsersSetting = 0;
  if (std::thread::hardware_concurrency() <= 2) setenv("LP_NUM_THREADS", "0", kKeepUsersSetting);
}

}  // namespace

struct OsmesaContext::Library {
  void* (*create)(const int* attributes, void* share) = nullptr;
  void (*destroy)(void* context) = nullptr;
  unsigned char (*make_current)(void* context, void* buffer, GLenum type, int width,
                                int height) = nullptr;
  void (*pixel_store)(int name, int value) = nullptr;
  GlProcLoader get_proc = nullptr;
  std::string problem;

  // Loaded once and kept: Mesa's threads and compiled code do not survive an unload.
  static const Library& Get() {
    static const Library library = Open();
    return library;
  }

 private:
  static Library Open() {
    Library library;
    ChooseMesaThreads();
    void* handle = dlopen(kLibraryName, RTLD_NOW | RTLD_LOCAL);
    const bool complete = handle != nullptr &&
                          Find(handle, "OSMesaCreateContextAttribs", library.create) &&
                          Find(handle, "OSMesaDestroyContext", library.destroy) &&
                          Find(handle, "OSMesaMakeCurrent", library.make_current) &&
                          Find(handle, "OSMesaPixelStore", library.pixel_store) &&
                          Find(handle, "OSMesaGetProcAddress", library.get_proc);
    const char* reason = complete ? nullptr : dlerror();
    if (!complete) library.problem = reason != nullptr ? reason : "the library is incomplete";
    return library;
  }
};

Result<OsmesaContext> OsmesaContext::Create() {
  const Library& library = Library::Get();
  if (!library.problem.empty()) return CannotLoad(library.problem);
  const int attributes[] = {kFormat,       kRgba, kDepthBits,    24, kProfile, kCoreProfile,
                            kMajorVersion, 3,     kMinorVersion, 3,  0};
  void* context = library.create(attributes, nullptr);
  if (context == nullptr) return CannotLoad("Mesa makes no OpenGL 3.3 context");
  return OsmesaContext(&library, context);
}

OsmesaContext::OsmesaContext(const Library* library, void* context)
    : library_(library), context_(context) {}

OsmesaContext::~OsmesaContext() {
  if (context_ != nullptr) library_->destroy(context_);
}

OsmesaContext::OsmesaContext(OsmesaContext&& other) noexcept { *this = std::move(other); }

OsmesaContext& OsmesaContext::operator=(OsmesaContext&& other) noexcept {
  std::swap(library_, other.library_);
  std::swap(context_, other.context_);
  return *this;
}

bool OsmesaContext::MakeCurrent(std::uint8_t* rgba, int width, int height) {
  if (library_->make_current(context_, rgba, GL_UNSIGNED_BYTE, width, height) == 0) return false;
  library_->pixel_store(kYUp, 0);
  return true;
}

GlProcLoader OsmesaContext::loader() const { return library_->get_proc; }

}  // namespace hazumi::render
