#pragma once

// Files of poses that are kept for any project: JSON, read and written as projects are. Degrees and
// metres.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

// Of the root, without where it is on the ground and where it looks.
struct SavedRoot {
  double height_m = 0.0;                        // its origin above the ground
  double angle_y_deg = 0.0, angle_x_deg = 0.0;  // of R = Rz Ry Rx
  // Of the same origin when the figure that the pose is of stands upright; not given: the human.
  std::optional<double> standing_height_m;
  ExtraFields extra;
  bool operator==(const SavedRoot&) const = default;
};

// Angles by hinge, for whatever figure has hinges of these names; others take the human's.
struct SavedPose {
  std::string name;
  std::optional<SavedRoot> root;
  std::vector<Named<double>> joints;
  // By hinge of the human that comes with Hazumi, whose names `joints` has if this is empty.
  std::vector<Named<double>> human;
  ExtraFields extra;
  bool operator==(const SavedPose&) const = default;
};

struct PoseFile {
  std::vector<SavedPose> poses;  // no two of one name
  ExtraFields extra;
  ReadReport read;
  bool operator==(const PoseFile&) const = default;
};

// The first thing wrong is reported with its place and a remedy: kNoInput (cannot be read), kSyntax
// (not JSON), kSchema (JSON of the wrong shape, numbers out of range, a name twice).
Result<PoseFile> LoadPoses(const std::string& path);
Result<PoseFile> ParsePoses(std::string_view text, const std::string& file_name);

std::string WritePoses(const PoseFile& file);

}  // namespace hazumi
