// Runs a fuzzer's inputs without a fuzzer: fuzz_NAME FILE_OR_FOLDER ... Every build runs all inputs
// that once crashed and those that show the format. An input may take at most ten seconds of
// processor time.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> FilesIn(const fs::path& path) {
  if (!fs::is_directory(path))
    return fs::exists(path) ? std::vector{path} : std::vector<fs::path>();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Whether it was done in time.
bool Run(const fs::path& path) {
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);  // the last line names what crashes
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::clock_t start = std::clock();
  LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  constexpr double kLongest = 10.0;  // [s]
  if (taken < kLongest) return true;
  std::fprintf(stderr, "%s: took %.1f s\n", path.c_str(), taken);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  int num_files = 0, num_slow = 0;
  for (int i = 1; i < argc; ++i) {
    for (const fs::path& path : FilesIn(argv[i])) {
      ++num_files;
      num_slow += !Run(path);
    }
  }
  std::printf("%d files\n", num_files);
  return num_files > 0 && num_slow == 0 ? 0 : 1;
}
