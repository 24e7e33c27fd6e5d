#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/child/reader_program.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/import/role_map.h"
#include "engine/project/project.h"

namespace hazumi {

// Limits of hinges.
enum class ImportLimits {
  kClip,  // as far as the clip goes, and somewhat beyond
  kNone,  // nowhere
};

// Which hinges joints get.
enum class ImportHinges {
  kBody,  // parts of a body the same ones in every figure, other joints the file's
  kFile,  // the file's, in its order
};

// Limits of the sampling rate [1/s].
inline constexpr double kLeastImportFps = 0.1, kMostImportFps = 1e4;

struct ImportOptions {
  std::string character;                  // name of one of several; empty: the one that moves most
  std::optional<double> fps;              // sampling rate of clips; default: the clip's own
  std::string clip;                       // by name; empty: the first one
  std::optional<UpAxis> up;               // not given: the file's, or guessed
  std::optional<double> metres_per_unit;  // not given: the file's, or guessed from the height
  std::optional<double> height_m;         // instead of metres_per_unit: how tall it shall be
  std::optional<double> mass_kg;          // not given: that of a person so tall
  std::optional<double> reduce_deg;  // fewer keys, this far off at most; not given: every frame
  ImportLimits limits = ImportLimits::kClip;
  ImportHinges hinges = ImportHinges::kBody;
  bool faces_forward = true;  // turned so that it faces x at rest; else as the file has it
  RoleMap roles;              // of bones whose role is told wrong
  bool skin = true;
};

// Returns the options with which the file of an import is read.
inline ReadOptions ReadOptionsFor(const ImportOptions& options) {
  ReadOptions reading;
  reading.character = options.character;
  reading.rate = options.fps.value_or(0.0);
  reading.keys_all_frames = !options.reduce_deg;
  return reading;
}

// The options with which a project was imported; of the file's limits and skin none is needed.
ImportOptions OptionsOf(const ProjectSource& source);

// A bone that has become a joint, or the root.
struct ImportedBone {
  std::string name;  // in the file
  int parent = -1;   // among these
  BodyPlace place;
  Vec3 position = Vec3::Zero();  // at rest [m]
};

// Report of an import, for the person who asked for it.
struct ImportReport {
  std::vector<std::string> facts;  // sentences: size, axes, clip, keys
  std::vector<Warning> warnings;   // what was guessed, dropped or repaired
  UpAxis up = UpAxis::kY;
  double metres_per_unit = 1.0;
  bool unit_is_guessed = false;
  double height_m = 0.0;          // of the figure at rest
  double position_error_m = 0.0;  // of a joint at any frame, the largest, against the file
  int num_joints = 0, num_keys = 0;
  std::vector<ImportedBone> bones;
};

struct Imported {
  Project project;
  ImportReport report;
};

// A project whose figure is made from the character's bones, with masses and limits, and whose keys
// are one of its clips. Figures are hinges: what else moves a bone is dropped and named in the
// report, with the error that this leaves. Errors: kSemantics if no figure can be made of it, or
// there is no such clip; kSchema if it has more or larger numbers than a project's file holds.
Result<Imported> ImportProject(const Character& character, const ImportOptions& options);

inline constexpr size_t kShortReport = 10;

// Warnings that say the same of several places become one that names them; of more than `most` the
// rest is counted. 0: all of them, as they are.
std::vector<Warning> Shortened(const std::vector<Warning>& warnings, size_t most);

}  // namespace hazumi
