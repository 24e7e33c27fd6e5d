#pragma once

namespace hazumi::ui {

// What is on top of the panels and has all keys; one at a time.
enum class Modal {
  kNone,
  kFiles,
  kUnsaved,
  kChangedElsewhere,
  kSearch,
  kForm,
  kImport,
  kExport,
  kRender,
  kProgress,
  kManual,
  kAbout,
  kPreferences,
  kOutsideFile
};

}  // namespace hazumi::ui
