#include "engine/project/shown_name.h"

#include <filesystem>

namespace hazumi {

std::string ShownName(const std::string& name, const std::string& file) {
  const bool is_named = !name.empty() && name != "Untitled";
  return is_named || file.empty() ? name : std::filesystem::path(file).stem().string();
}

}  // namespace hazumi
