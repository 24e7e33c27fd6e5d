#include "engine/exchange/scene/scene_folder.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/input_files.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {
namespace {

namespace fs = std::filesystem;

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// "my%20file.png" as URIs have it.
std::string PercentDecoded(const std::string& text) {
  std::string decoded;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && i + 2 < text.size() && HexDigit(text[i + 1]) >= 0 &&
                         HexDigit(text[i + 2]) >= 0;
    decoded +=
        is_code ? static_cast<char>(HexDigit(text[i + 1]) * 16 + HexDigit(text[i + 2])) : text[i];
    if (is_code) i += 2;
  }
  return decoded;
}

bool IsAbsolute(const std::string& name) {
  return name.starts_with("/") || (name.size() > 1 && name[1] == ':');
}

}  // namespace

SceneFolder::SceneFolder(const std::string& scene_path) {
  std::error_code error;
  path_ = fs::canonical(fs::absolute(scene_path, error).parent_path(), error).string();
}

std::optional<std::string> SceneFolder::Resolve(std::string name) const {
  std::replace(name.begin(), name.end(), '\\', '/');
  if (name.starts_with(path_ + "/")) name.erase(0, path_.size() + 1);
  // Other people's absolute paths: the file may lie beside the scene.
  if (IsAbsolute(name)) name = fs::path(name).filename().string();
  std::error_code error;
  for (const std::string& candidate : {name, PercentDecoded(name)}) {
    const fs::path file = fs::path(path_) / candidate;
    if (!candidate.empty() && fs::is_regular_file(file, error) && LiesIn(file.string(), path_))
      return file.string();
  }
  return std::nullopt;
}

std::optional<std::string> SceneFolder::Contents(const std::string& name) {
  if (const std::optional<std::string> file = Resolve(name)) {
    Result<std::string> bytes = WholeFile(*file, kLongestFile);
    if (bytes.ok()) return std::move(bytes).value();
  }
  const bool is_long = name.starts_with(path_ + "/");
  if (refused_.size() < 20) refused_.push_back(is_long ? name.substr(path_.size() + 1) : name);
  return std::nullopt;
}

}  // namespace hazumi
