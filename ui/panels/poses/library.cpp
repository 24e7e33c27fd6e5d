#include "ui/panels/poses/library.h"

#include <algorithm>

#include "engine/base/atomic_file.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::ui {

namespace fs = std::filesystem;

namespace {

const SavedPose* FindIn(const std::string& name, const std::vector<SavedPose>& poses) {
  const auto found = std::find_if(poses.begin(), poses.end(),
                                  [&](const SavedPose& pose) { return pose.name == name; });
  return found == poses.end() ? nullptr : &*found;
}

}  // namespace

std::optional<PoseLibrary::Stamp> PoseLibrary::StampNow() const {
  std::error_code failed;
  const auto time = fs::last_write_time(path_, failed);
  if (path_.empty() || failed) return std::nullopt;
  return Stamp{time, fs::file_size(path_, failed)};
}

std::optional<Error> PoseLibrary::Refresh() {
  const std::optional<Stamp> now = StampNow();
  if (now == stamp_) return error_;
  stamp_ = now;
  ++revision_;
  error_.reset();
  file_ = {};
  if (!now) return error_;
  Result<PoseFile> read = LoadPoses(path_);
  if (read.ok()) {
    file_ = std::move(read).value();
  } else {
    error_ = read.error();
  }
  return error_;
}

const SavedPose* PoseLibrary::Find(const std::string& name) const {
  const SavedPose* own = FindIn(name, file_.poses);
  return own ? own : FindIn(name, ShippedPoses());
}

bool PoseLibrary::IsOwn(const std::string& name) const { return FindIn(name, file_.poses); }

// What cannot be read is not written over.
Result<Done> PoseLibrary::Write(PoseFile file) {
  std::error_code failed;
  fs::create_directories(fs::path(path_).parent_path(), failed);
  Result<Done> written =
      WriteFileAtomically(path_, WritePoses(file), WriteMode::kFast, nullptr, InputKind::kPoses);
  if (!written.ok()) return written;
  file_ = std::move(file);
  stamp_ = StampNow();
  ++revision_;
  return written;
}

Result<Done> PoseLibrary::Save(SavedPose pose, bool replaces) {
  if (path_.empty()) {
    return Refusal("", "there is no folder for poses; set XDG_CONFIG_HOME or HOME to one");
  }
  if (pose.name.empty()) return Refusal("name", "must not be empty");
  if (const auto error = Refresh()) return *error;
  if (FindIn(pose.name, ShippedPoses())) {
    return Refusal("name", "\"" + pose.name + "\" comes with Hazumi; choose another name");
  }
  PoseFile file = file_;
  const auto there = std::find_if(file.poses.begin(), file.poses.end(),
                                  [&](const SavedPose& other) { return other.name == pose.name; });
  if (there == file.poses.end()) {
    file.poses.push_back(std::move(pose));
  } else if (replaces) {
    *there = std::move(pose);
  } else {
    return Refusal("name", "there is a pose \"" + pose.name +
                               "\" already; choose another name, or replace it");
  }
  return Write(std::move(file));
}

Result<SavedPose*> PoseLibrary::OwnNamed(const std::string& name, PoseFile* file) {
  if (const auto error = Refresh()) return *error;
  *file = file_;
  for (SavedPose& pose : file->poses) {
    if (pose.name == name) return &pose;
  }
  return Refusal("name", FindIn(name, ShippedPoses())
                             ? "\"" + name + "\" comes with Hazumi and stays as it is"
                             : "there is no pose \"" + name + "\" of your own");
}

Result<Done> PoseLibrary::Rename(const std::string& name, const std::string& to) {
  PoseFile file;
  const Result<SavedPose*> pose = OwnNamed(name, &file);
  if (!pose.ok()) return pose.error();
  if (to.empty()) return Refusal("to", "must not be empty");
  if (to != name && Find(to)) return Refusal("to", "there is a pose \"" + to + "\" already");
  pose.value()->name = to;
  return Write(std::move(file));
}

Result<Done> PoseLibrary::Remove(const std::string& name) {
  PoseFile file;
  const Result<SavedPose*> pose = OwnNamed(name, &file);
  if (!pose.ok()) return pose.error();
  file.poses.erase(file.poses.begin() + (pose.value() - file.poses.data()));
  return Write(std::move(file));
}

}  // namespace hazumi::ui
