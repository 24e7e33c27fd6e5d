#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hazumi {

// The files that a scene may name: those in its own folder and below, by no way out.
class SceneFolder {
 public:
  explicit SceneFolder(const std::string& scene_path);

  const std::string& path() const { return path_; }
  // A file of the folder, by a name as scenes have it: with / or \, or percent-encoded. None: it is
  // not there, or lies elsewhere.
  std::optional<std::string> Contents(const std::string& name);
  bool Has(const std::string& name) const { return Resolve(name).has_value(); }
  // Names for which there were none.
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  // Path of an existing file within the folder.
  std::optional<std::string> Resolve(std::string name) const;

  std::string path_;
  std::vector<std::string> refused_;
};

}  // namespace hazumi
