#include "ui/panels/dialogs/folder_list.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "engine/base/text.h"

namespace hazumi::ui {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSuffix = ".kfa";

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The digits from a place on, without zeros before them; moves the place behind them.
std::string DigitsAt(const std::string& text, size_t* at) {
  while (*at < text.size() && text[*at] == '0') ++*at;
  const size_t first = *at;
  while (*at < text.size() && IsDigit(text[*at])) ++*at;
  return text.substr(first, *at - first);
}

std::int64_t ChangedAt(const fs::directory_entry& entry) {
  std::error_code failed;
  const fs::file_time_type time = entry.last_write_time(failed);
  if (failed) return 0;
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

bool EndsInOneOf(std::initializer_list<const char*> suffixes, const std::string& path) {
  const std::string name = LowerCase(path);
  return std::any_of(suffixes.begin(), suffixes.end(),
                     [&](const char* suffix) { return name.ends_with(suffix); });
}

// glTF, FBX and Collada hold both characters and meshes.
bool IsScene(const std::string& path) {
  return EndsInOneOf({".fbx", ".gltf", ".glb", ".dae"}, path);
}

}  // namespace

bool IsProject(const std::string& path) { return EndsInOneOf({kSuffix}, path); }

bool IsOfOtherProgram(const std::string& path) {
  return IsScene(path) || EndsInOneOf({".bvh"}, path);
}

bool IsMesh(const std::string& path) { return IsScene(path) || EndsInOneOf({".obj"}, path); }

bool IsExport(const std::string& path) {
  return EndsInOneOf({".bvh", ".gltf", ".glb", ".csv", ".json", ".mp4"}, path);
}

bool IsVideo(const std::string& path) {
  return EndsInOneOf({".mp4", ".mov", ".mkv", ".webm", ".avi"}, path);
}

bool IsSound(const std::string& path) {
  return IsVideo(path) || EndsInOneOf({".wav", ".mp3", ".ogg", ".opus", ".flac", ".m4a", ".aac",
                                       ".aif", ".aiff", ".wma"},
                                      path);
}

bool IsReference(const std::string& path) {
  return IsVideo(path) ||
         EndsInOneOf({".png", ".jpg", ".jpeg", ".gif", ".webp", ".bmp", ".tif", ".tiff"}, path);
}

bool IsShown(const FileEntry& entry, const FolderFilter& filter) {
  if (entry.name.starts_with('.')) return false;
  if (entry.is_folder) return true;
  return filter.wanted && (filter.all_files || filter.wanted(entry.name));
}

bool ComesBefore(const std::string& a, const std::string& b) {
  const std::string left = LowerCase(a), right = LowerCase(b);
  size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    if (IsDigit(left[i]) && IsDigit(right[j])) {
      const std::string m = DigitsAt(left, &i), n = DigitsAt(right, &j);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    if (left[i] != right[j]) {
      return static_cast<unsigned char>(left[i]) < static_cast<unsigned char>(right[j]);
    }
    ++i, ++j;
  }
  const size_t rest_left = left.size() - i, rest_right = right.size() - j;
  return rest_left != rest_right ? rest_left < rest_right : a < b;
}

void SortEntries(FileOrder order, std::vector<FileEntry>* entries) {
  std::sort(entries->begin(), entries->end(), [&](const FileEntry& a, const FileEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    if (order == FileOrder::kNewest && a.changed != b.changed) return a.changed > b.changed;
    return ComesBefore(a.name, b.name);
  });
}

Result<std::vector<FileEntry>> ListFolder(const std::string& folder, const FolderFilter& filter) {
  std::error_code failed;
  std::vector<FileEntry> entries;
  fs::directory_iterator it(folder, failed);
  for (; !failed && it != fs::directory_iterator(); it.increment(failed)) {
    std::error_code unknown;  // a link to nothing is no folder
    FileEntry entry{it->path().filename().string(), it->is_directory(unknown), ChangedAt(*it)};
    if (IsShown(entry, filter)) entries.push_back(std::move(entry));
  }
  if (failed) {
    return Error{ErrorCode::kNoInput, folder, "", "cannot be read: " + failed.message()};
  }
  SortEntries(filter.order, &entries);
  return entries;
}

std::string ParentOf(const std::string& folder) {
  const fs::path path(folder);
  return path.has_relative_path() ? path.parent_path().string() : path.string();
}

std::string NameIn(const std::string& path) { return fs::path(path).filename().string(); }

std::string PathOf(const std::string& folder, const std::string& typed, const std::string& home) {
  fs::path path(typed);
  if (typed == "~" || typed.starts_with("~/")) {
    path = fs::path(home) / typed.substr(std::min<size_t>(typed.size(), 2));
  } else if (!path.is_absolute()) {
    path = fs::path(folder) / path;
  }
  path = path.lexically_normal();
  const bool ends_with_slash = !path.has_filename() && path.has_relative_path();
  return (ends_with_slash ? path.parent_path() : path).string();
}

std::string WithProjectSuffix(const std::string& name) {
  return IsProject(name) ? name : name + kSuffix;
}

int FirstBeginningWith(const std::vector<FileEntry>& entries, const std::string& typed) {
  const std::string wanted = LowerCase(typed);
  if (wanted.empty()) return -1;
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const FileEntry& entry) {
    return LowerCase(entry.name).starts_with(wanted);
  });
  return found == entries.end() ? -1 : static_cast<int>(found - entries.begin());
}

std::string HomeFolder() {
  const char* home = std::getenv("HOME");
  return home && *home ? home : "/";
}

std::string ProgramPath() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).string();
}

std::string ExamplesBeside(const std::string& program) {
  return (fs::path(program).parent_path().parent_path() / "share" / "hazumi" / "examples").string();
}

std::vector<Shelf> Shelves(const std::string& home, const std::vector<std::string>& recent_files,
                           const std::string& examples) {
  std::vector<Shelf> shelves = {{"Home", home},
                                {"Desktop", home + "/Desktop"},
                                {"Documents", home + "/Documents"},
                                {"Computer", "/"}};
  if (!examples.empty()) shelves.push_back({"Examples", examples});
  for (const std::string& file : recent_files) {
    const std::string folder = ParentOf(file);
    const bool is_known = std::any_of(shelves.begin(), shelves.end(),
                                      [&](const Shelf& shelf) { return shelf.path == folder; });
    if (!is_known && !NameIn(folder).empty()) shelves.push_back({NameIn(folder), folder});
  }
  std::error_code unknown;
  std::erase_if(shelves, [&](const Shelf& s) { return !fs::is_directory(s.path, unknown); });
  return shelves;
}

}  // namespace hazumi::ui
