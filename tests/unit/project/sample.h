#pragma once

// A small but complete project for the tests, and ways to change it.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/project/json.h"
#include "engine/project/project.h"

namespace hazumi::testing {

// Every kind of object of the format, once at least. The figure is embedded.
Json SampleProject();

// A change: a JSON pointer and the new value as JSON text; empty: the field is removed.
using Changes = std::vector<std::pair<std::string, std::string>>;
Json Changed(Json document, const Changes& changes);

// Demands that it can be read.
Project ParseGood(const Json& document);

// A folder of its own for one test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  size_t num_entries() const;

 private:
  std::filesystem::path path_;
};

std::string ReadFile(const std::string& path);
void WriteFile(const std::string& path, const std::string& text);

}  // namespace hazumi::testing
