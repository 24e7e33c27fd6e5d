#pragma once

// Files of other programs: the motion of a session as one, and the project made of one.

#include <optional>
#include <string>

#include "engine/exchange/export_motion.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/onto/export_onto.h"
#include "engine/project/project_figure.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// The meshes of a glTF file: those the character came with, one for each of the figure's capsules,
// or none, which leaves the skeleton.
enum class ExportSkin { kCharacter, kCapsules, kNone };
const char* NameOf(ExportSkin skin);

struct ExportSettings {
  MotionFormat format = MotionFormat::kGlb;
  int first = 0, last = 0;  // frames, both written
  UpAxis up = UpAxis::kY;   // of BVH, as is the next
  double metres_per_unit = 0.01;
  ExportSkin skin = ExportSkin::kNone;  // of glTF
  bool torques = false;                 // of JSON and CSV
  // The file to put the motion into, and where the file made of it is to be written; empty: none,
  // the motion is written by itself.
  std::string onto = {}, path = {};
  bool operator==(const ExportSettings&) const = default;
};

// All that a file is made of, so that the session may go on while it is.
struct ExportSource {
  Animation animation;
  Motion motion;  // all frames
  ProjectSkin character;
  SkinMaker capsules;
  std::string name;  // of the clip
  std::optional<ProjectSource> imported_from;
};
// Bakes what has to be. Errors: those of Session::WholeMotion.
Result<ExportSource> ExportSourceOf(Session* session);
// All frames, and of the skins that there are the one that shows most.
ExportSettings UsualSettings(const Session& session, MotionFormat format);

// The file of `settings.onto` with the motion put into it. Errors: those of ExportOnto.
Result<OntoFile> OntoFileOf(const ExportSource& source, const ExportSettings& settings);

// The bytes of the file. Errors: a skin that is not there (kSchema), and those of ExportMotion.
Result<std::string> BytesOf(const ExportSource& source, const ExportSettings& settings);

// Error (kCannotWrite) if a file cannot be written there: no folder, a folder of this name, or an
// input of the program. To be asked before anything is computed.
std::optional<Error> CheckPlace(const std::string& path);

// Makes an imported project that of the session: not saved, without a file, nothing to undo.
void TakeImported(Imported imported, Session* session);

}  // namespace hazumi::edit
