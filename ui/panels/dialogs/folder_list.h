#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace hazumi::ui {

// What is in a folder. Names are bytes as the system gives them, mostly UTF-8.
struct FileEntry {
  std::string name;
  bool is_folder = false;
  std::int64_t changed = 0;  // seconds since 1970
  bool operator==(const FileEntry&) const = default;
};

enum class FileOrder { kName, kNewest };

struct FolderFilter {
  bool (*wanted)(const std::string& path) = nullptr;  // which files are shown; null: folders alone
  bool all_files = false;  // else those that are wanted; what begins with a dot is never shown
  FileOrder order = FileOrder::kName;
};

// Called as projects are.
bool IsProject(const std::string& path);
// Called as files of other programs are that can be imported.
bool IsOfOtherProgram(const std::string& path);
// Called as files with meshes.
bool IsMesh(const std::string& path);
// Called as what File > Export writes.
bool IsExport(const std::string& path);
// Called as sounds and videos are, or as pictures and videos; there are more that ffmpeg reads.
bool IsSound(const std::string& path);
bool IsReference(const std::string& path);
bool IsShown(const FileEntry& entry, const FolderFilter& filter);
// Folders first. Names as people count: "shot 2" before "shot 10", upper case as lower.
void SortEntries(FileOrder order, std::vector<FileEntry>* entries);
bool ComesBefore(const std::string& a, const std::string& b);
// Filtered and sorted. Error: kNoInput, the folder cannot be read.
Result<std::vector<FileEntry>> ListFolder(const std::string& folder, const FolderFilter& filter);

// The folder above; "/" is its own.
std::string ParentOf(const std::string& folder);
// The last part of a path.
std::string NameIn(const std::string& path);
// A typed name as a path: absolute, from ~ on, or in the folder; without "." and "..".
std::string PathOf(const std::string& folder, const std::string& typed, const std::string& home);
// A name for a project: ".kfa" behind it unless it is there.
std::string WithProjectSuffix(const std::string& name);
// The first entry that begins with what was typed, upper case as lower; -1: none.
int FirstBeginningWith(const std::vector<FileEntry>& entries, const std::string& typed);

std::string HomeFolder();
// Folders to go to at once, by label and path; those that exist.
struct Shelf {
  std::string label;  // English, or a name
  std::string path;
};
// `examples` may be empty: none.
std::vector<Shelf> Shelves(const std::string& home, const std::vector<std::string>& recent_files,
                           const std::string& examples);
// The shipped examples, as they are installed beside a program (this one: ProgramPath()).
std::string ExamplesBeside(const std::string& program);
std::string ProgramPath();

}  // namespace hazumi::ui
