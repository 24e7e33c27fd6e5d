#pragma once

#include <string>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// $XDG_CONFIG_HOME/hazumi/settings.json; without that variable ~/.config.
std::string SettingsPath();
// The user's own poses, beside the settings: poses.json.
std::string PosesPath();

// As JSON, and back. What a text does not say stays as `otherwise` has it. Error: kSyntax or
// kSchema, the place being the field.
std::string WriteSettings(const Settings& settings);
Result<Settings> ReadSettings(const std::string& text, const Settings& otherwise);

// The settings' file of an editor: read once, written when they have changed.
class SettingsFile {
 public:
  explicit SettingsFile(std::string path) : path_(std::move(path)) {}

  // Reads it; where it names no language, that is the system's, as it is without a file. A damaged
  // one is kept aside as "settings.json.damaged", which the status bar says.
  void Load(Editor* editor);
  // Writes it if they differ from what was read or written last. What goes wrong is said once.
  void SaveIfChanged(Editor* editor);

 private:
  std::string path_;
  Settings last_;
};

}  // namespace hazumi::ui
