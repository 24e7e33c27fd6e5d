#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/base/result.h"
#include "engine/exchange/import/import_project.h"

namespace hazumi::ui {

class Editor;

// Reads a character beside the interface. Ends with its object, cancelled.
class ImportJob {
 public:
  ImportJob(std::string path, const ImportOptions& options);
  ~ImportJob();

  const std::string& path() const { return path_; }
  // Null before it has ended.
  const Result<Character>* character() const { return has_ended_ ? &*character_ : nullptr; }

 private:
  std::string path_, character_name_;
  double rate_;  // frames a second; 0: the clip's
  std::atomic<bool> cancel_ = false, has_ended_ = false;
  std::optional<Result<Character>> character_;  // written before has_ended_ is
  std::thread thread_;
};

// The import dialog: what is read, how, and what would come of it.
struct ImportState {
  ImportOptions options;
  bool reduces = false;
  double reduce_deg = 1.0;
  double height_m = 0.0, mass_kg = 0.0;  // 0: as guessed
  double fps = 0.0;                      // 0: the clip's
  std::shared_ptr<ImportJob> job;
  int bone = -1;                             // of the report's bones, chosen; -1: none
  std::optional<Result<Imported>> imported;  // with these options; none: not tried yet
};

// Reads the file again, with another character of it, or with as many frames as the state says.
void ChooseCharacter(const std::string& name, ImportState* state);
void ChooseRate(ImportState* state);
// Starts to read a file and shows the dialog.
void OpenImport(const std::string& path, Editor* editor);
// Makes the project again that the options ask for, once the character is there.
void RefreshImport(ImportState* state);
// Makes it that of the editor; the dialog closes.
void FinishImport(Editor* editor);

}  // namespace hazumi::ui
