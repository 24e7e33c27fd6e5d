#include "engine/base/file_place.h"

#include <filesystem>

namespace hazumi {

namespace fs = std::filesystem;

std::string FollowLinks(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : target.string();
}

bool LiesIn(const std::string& file, const std::string& folder) {
  std::error_code failed;
  const fs::path target = fs::canonical(file, failed);
  if (failed) return false;
  const fs::path around = fs::canonical(folder.empty() ? "." : folder, failed);
  if (failed) return false;
  const fs::path inside = target.lexically_relative(around);
  return !inside.empty() && *inside.begin() != ".." && inside != ".";
}

}  // namespace hazumi
