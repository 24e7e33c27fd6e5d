#include "ui/shell/openal.h"

#include <dlfcn.h>

#include <optional>

namespace hazumi::ui {

namespace {

std::optional<OpenAl> Loaded() {
  void* library = dlopen("libopenal.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::nullopt;
  OpenAl al;
  bool has_all = true;
  const auto load = [&](const char* name, auto* function) {
    *function = reinterpret_cast<std::remove_pointer_t<decltype(function)>>(dlsym(library, name));
    has_all &= *function != nullptr;
  };
#define HAZUMI_OPENAL_LOAD(type, name) load(#name, &al.name);
  HAZUMI_OPENAL(HAZUMI_OPENAL_LOAD)
#undef HAZUMI_OPENAL_LOAD
  return has_all ? std::optional(al) : std::nullopt;
}

}  // namespace

const OpenAl* LoadOpenAl() {
  static const std::optional<OpenAl> al = Loaded();
  return al ? &*al : nullptr;
}

}  // namespace hazumi::ui
