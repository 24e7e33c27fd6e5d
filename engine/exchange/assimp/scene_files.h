#pragma once

#include <assimp/IOSystem.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hazumi {

// The files that a scene may name: those in its own folder and below, by no way out. assimp opens
// all files by this.
class SceneFiles : public Assimp::IOSystem {
 public:
  // The scene itself is `bytes`, under the name `main_name()`: its path with the suffix that assimp
  // expects of the format.
  SceneFiles(std::string bytes, const std::string& path, const std::string& suffix);

  const std::string& main_name() const { return main_name_; }
  const std::string& main_bytes() const { return bytes_; }
  void SetMainBytes(std::string bytes) { bytes_ = std::move(bytes); }
  // Names that lead out of the folder; files that are not there.
  const std::vector<std::string>& refused() const { return refused_; }
  // A file of the folder, by a name as scenes have it: with / or \, or percent-encoded.
  std::optional<std::string> Contents(const std::string& name);

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  // Path of an existing file within the folder.
  std::optional<std::string> Resolve(std::string name) const;

  std::string bytes_, folder_, main_name_;
  std::vector<std::string> refused_;
};

}  // namespace hazumi
