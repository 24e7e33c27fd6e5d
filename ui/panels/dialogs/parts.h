#pragma once

// Internal: what the dialogs are drawn by, each inside of the window that dialogs_draw.cpp opens.

#include <imgui.h>

#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

void DrawFileDialog(Editor* editor);
void DrawSearch(Editor* editor);
void DrawForm(Editor* editor);
void DrawImport(Editor* editor);
// What the bones are, to be changed. True once it was.
bool DrawRoles(const Editor& editor, ImportState* state);
void DrawExport(Editor* editor);
void DrawRenderDialog(Editor* editor);
void DrawProgress(Editor* editor);
// Rows of fields that dialogs share: of a picture's size, and of what is seen on it.
void DrawSizeFields(const Editor& editor, int* width, int* height);
void DrawViewFields(const Editor& editor, bool* through_project_camera, bool* overlays);
void DrawManual(Editor* editor);
void DrawAbout(Editor* editor);
void DrawPreferences(Editor* editor);
// Whether a sound or reference outside of the project's folder is opened. It is asked once nothing
// else is.
void AskAboutOutsideFile(Editor* editor);
void DrawOutsideFile(Editor* editor);
// Where keys count.
const char* LabelOf(Place place);
// What a shortcut does, as the menus call it.
std::string LabelOf(const Shortcut& shortcut);
// A window of its own, beside the panels.
void DrawFirstSteps(Editor* editor, const Rect& window);

// What stands before the fields of a row; these begin below each other.
void DrawFieldLabel(const char* text, const Editor& editor);
// Tab goes to what is drawn while this lives, or passes over it: arrows lead there, and the mouse.
class TabStops {
 public:
  explicit TabStops(bool are_stops);
  ~TabStops();
  TabStops(const TabStops&) = delete;
  TabStops& operator=(const TabStops&) = delete;
};
// What was drawn last has the keyboard, and that is seen.
bool HasKeyboard();
// A line of a list that is chosen by a click, and by Enter or Space where arrows have led to it.
bool ListLine(const std::string& label, bool is_selected);

// Neither counts while a list of the dialog is open, nor Enter where it does something else.
bool IsEnterPressed(const Editor& editor);
bool IsEscapePressed(const Editor& editor);
// An error, with a sign, on as many lines as it needs, of which a few are seen and the rest is
// scrolled to; nothing if it is empty.
void DrawError(const std::string& error, const Theme& theme);
// How high that is, with the gap below it [px].
float HeightOfError(const std::string& error);

struct ButtonText {
  const char* label;  // in the interface's language
  const char* help;   // empty: the label says it
};
// A row of buttons at the right; the first one is what Enter does. Which was clicked; -1: none.
int DrawButtons(const Editor& editor, std::initializer_list<ButtonText> buttons);

}  // namespace hazumi::ui
