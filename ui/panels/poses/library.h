#pragma once

// Poses that are there in every project: those that come with Hazumi, and the user's own, in a
// file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/project/pose_file.h"

namespace hazumi::ui {

// Those that come with Hazumi, for its human.
const std::vector<SavedPose>& ShippedPoses();

class PoseLibrary {
 public:
  // Where the user's own are kept; empty, as at first: nowhere, and none can be saved.
  void set_path(std::string path) { path_ = std::move(path); }

  // Looks whether the file was written since, by this or another program. Why it cannot be read, if
  // it cannot be; there are no own poses then.
  std::optional<Error> Refresh();
  // As of then.
  const std::vector<SavedPose>& own() const { return file_.poses; }
  // Own ones go before those that come with Hazumi. Null: there is none.
  const SavedPose* Find(const std::string& name) const;
  bool IsOwn(const std::string& name) const;
  // Counts up whenever the own ones change.
  long revision() const { return revision_; }

  // Adds a pose; one of its name is refused unless it `replaces`. Errors: of the file.
  Result<Done> Save(SavedPose pose, bool replaces);
  // Of own poses.
  Result<Done> Rename(const std::string& name, const std::string& to);
  Result<Done> Remove(const std::string& name);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::optional<Stamp> StampNow() const;
  Result<Done> Write(PoseFile file);
  Result<SavedPose*> OwnNamed(const std::string& name, PoseFile* file);

  std::string path_;
  PoseFile file_;
  std::optional<Stamp> stamp_;  // of what was read; none: no file
  std::optional<Error> error_;
  long revision_ = 0;
};

}  // namespace hazumi::ui
