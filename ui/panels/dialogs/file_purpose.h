#pragma once

#include <string>
#include <vector>

#include "ui/panels/dialogs/modal.h"

namespace hazumi::ui {

class Editor;

// What the file dialog is opened for: all in which its uses differ.
struct FilePurpose {
  const char* title;
  const char* nothing;  // what is said of a folder that has nothing to show
  const char* button;
  const char* button_help;
  bool (*wanted)(const std::string& path);  // which files are shown; null: it chooses a folder
  void (*take)(Editor* editor);             // what is named
  bool writes = false;                      // what is named may be new
  Modal back = Modal::kNone;                // the dialog that it was opened from
  const char* advice = "";                  // what to choose, where the title does not tell
};

extern const FilePurpose kOpenProject, kSaveProject, kImportCharacter, kChooseSound,
    kChooseReference, kChooseMesh, kChooseSweep, kChooseFolder, kChooseExport, kChooseOnto;
const std::vector<const FilePurpose*>& AllFilePurposes();

}  // namespace hazumi::ui
