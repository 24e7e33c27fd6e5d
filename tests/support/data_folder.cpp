#include "tests/support/data_folder.h"

#include <algorithm>
#include <cstdlib>

namespace hazumi::test {

namespace fs = std::filesystem;

bool DataIsPromised() {
  const char* folder = std::getenv("HAZUMI_DATA");
  return folder != nullptr && *folder != '\0';
}

std::string DataPath(const std::string& name) {
  const std::string folder =
      DataIsPromised() ? std::getenv("HAZUMI_DATA") : HAZUMI_SOURCE_DIR "/../shared/data";
  return folder + "/" + name;
}

std::vector<fs::path> DataFiles(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(DataPath(folder), error)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string MissingData(const std::string& name) {
  if (fs::is_regular_file(DataPath(name)) || !DataFiles(name).empty()) return "";
  return "no data: " + DataPath(name) + " is not there or empty" +
         (DataIsPromised() ? ", though HAZUMI_DATA is set" : "; HAZUMI_DATA names the folder");
}

}  // namespace hazumi::test
