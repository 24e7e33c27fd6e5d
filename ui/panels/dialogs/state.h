#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ui/edit/parameters.h"
#include "ui/edit/recovery/recovery.h"
#include "ui/panels/commands/first_steps.h"
#include "ui/panels/commands/search.h"
#include "ui/panels/dialogs/export_job.h"
#include "ui/panels/dialogs/file_purpose.h"
#include "ui/panels/dialogs/folder_list.h"
#include "ui/panels/dialogs/import_job.h"
#include "ui/panels/dialogs/render_job.h"
#include "ui/panels/forms/parameter_form.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// Work that a crash left behind and that the user has not been asked about yet.
struct RecoveryState {
  std::vector<edit::AbandonedJournal> journals;
  // Takes the work up again, or throws it away; given by whoever keeps the journals.
  std::function<void(const edit::AbandonedJournal& journal, bool recovers)> answer;
};

class Editor;

// What goes on once a question is answered. An error is shown where it was asked.
using Then = std::function<Result<Done>(Editor*)>;

struct FileDialogState {
  const FilePurpose* purpose = &kOpenProject;
  std::string folder;
  FolderFilter filter;
  std::vector<FileEntry> entries;  // of the folder
  int selected = -1;               // of the entries; -1: none
  std::string name;                // as typed
  std::string error;
  bool asks_overwrite = false;
  Then then;  // after it was saved
};

struct PreferencesState {
  std::string filter;  // of the keys
  int waits = -1;      // which of the shortcuts is given the next key that is pressed
};

struct DialogsState {
  Modal modal = Modal::kNone;
  bool just_opened = false;  // nothing of it was drawn yet
  bool has_list = false;     // one of its lists is open, which has the keys
  // What has the keyboard does something by these itself.
  bool takes_enter = false, takes_arrows = false;
  Then then;  // after a question about what is not saved
  FileDialogState files;
  SearchState search;
  FormState form;
  ImportState import;
  std::pair<long, std::string> imported = {-1, ""};  // document, and the file that it came from
  ExportState exporting;
  RenderState render;
  PreferencesState preferences;
  // Files outside of the project's folder: that which is asked about, and those kept closed.
  std::string asked_outside;
  std::set<std::string> kept_closed;
  bool shows_first_steps = false;
  FirstSteps first_steps;
  Rect first_steps_card;  // where it is, as long as it is shown
};

}  // namespace hazumi::ui
